#ifndef STANDIN_LIGHTING
#define STANDIN_LIGHTING
half4 _LightColor0;
#endif
