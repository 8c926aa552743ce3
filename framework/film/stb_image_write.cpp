// Not with STBI_WRITE_NO_STDIO, which also leaves out writing HDR to memory.
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
