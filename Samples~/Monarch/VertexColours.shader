// Vertex colours, lit from a fixed side and seen from both. One plain pass, which the built-in pipeline and URP both draw.
Shader "Alate/Samples/Vertex Colours"
{
    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }
        Cull Off

        Pass
        {
            CGPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #include "UnityCG.cginc"

            struct Attributes
            {
                float4 position : POSITION;
                float3 normal : NORMAL;
                float4 colour : COLOR;
            };

            struct Varyings
            {
                float4 position : SV_POSITION;
                float3 normal : TEXCOORD0;
                float3 towardsEye : TEXCOORD1;
                float4 colour : COLOR;
            };

            Varyings Vertex(Attributes corner)
            {
                Varyings v;
                v.position = UnityObjectToClipPos(corner.position);
                v.normal = UnityObjectToWorldNormal(corner.normal);
                v.towardsEye = _WorldSpaceCameraPos - mul(unity_ObjectToWorld, corner.position).xyz;
                v.colour = corner.colour;
                return v;
            }

            float4 Fragment(Varyings v) : SV_Target
            {
                float3 normal = normalize(v.normal);
                normal = dot(normal, v.towardsEye) < 0 ? -normal : normal;
                float light = 0.7 + 0.3 * dot(normal, normalize(float3(0.35, 0.85, -0.4)));
                float3 colour = v.colour.rgb;
                #ifndef UNITY_COLORSPACE_GAMMA
                colour = GammaToLinearSpace(colour);
                #endif
                return float4(colour * light, 1);
            }
            ENDCG
        }
    }
}
