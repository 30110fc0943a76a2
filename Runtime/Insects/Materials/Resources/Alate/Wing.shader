// Wings and bodies with vertex colours or a texture, seen from both sides, with light that shines through. Two SubShaders: URP (14 and newer) and the built-in
// pipeline. HDRP has no SubShader here: Alate.WingMaterial takes HDRP/Lit there.
Shader "Alate/Wing"
{
    Properties
    {
        [MainTexture] _MainTex ("Texture", 2D) = "white" {}
        [MainColor] _Color ("Tint", Color) = (1, 1, 1, 1)
        [ToggleUI] _VertexColours ("Vertex Colours", Float) = 1
        _Through ("Light Through", Range(0, 1)) = 0.5
        _Gloss ("Gloss", Range(0, 1)) = 0.12
        _Shine ("Shine", Range(4, 128)) = 24
        [Enum(UnityEngine.Rendering.CullMode)] _Cull ("Cull", Float) = 0
        [ToggleUI] _Translucent ("Translucent", Float) = 0
        [HideInInspector] _SrcBlend ("Source Blend", Float) = 1
        [HideInInspector] _DstBlend ("Destination Blend", Float) = 0
        [HideInInspector] _ZWrite ("Depth Write", Float) = 1
    }

    SubShader
    {
        PackageRequirements
        {
            "com.unity.render-pipelines.universal": "14.0.0"
        }

        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" "Queue" = "Geometry" }
        Cull [_Cull]

        HLSLINCLUDE
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
        #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"
        #include "../../WingLight.hlsl"

        CBUFFER_START(UnityPerMaterial)
            float4 _MainTex_ST;
            half4 _Color;
            half _VertexColours;
            half _Through;
            half _Gloss;
            half _Shine;
            half _Cull;
            half _Translucent;
            half _SrcBlend;
            half _DstBlend;
            half _ZWrite;
        CBUFFER_END

        TEXTURE2D(_MainTex);
        SAMPLER(sampler_MainTex);

        half4 Paint(half4 vertexColour, float2 uv)
        {
            #ifndef UNITY_COLORSPACE_GAMMA
            vertexColour.rgb = SRGBToLinear(vertexColour.rgb);
            #endif
            half4 paint = SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, uv) * _Color * lerp(half4(1, 1, 1, 1), vertexColour, _VertexColours);
            paint.a = lerp(1, paint.a, _Translucent);
            return paint;
        }
        ENDHLSL

        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "UniversalForwardOnly" }
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]

            HLSLPROGRAM
            #pragma target 3.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE
            #pragma multi_compile _ _ADDITIONAL_LIGHTS
            #pragma multi_compile _ _FORWARD_PLUS _CLUSTER_LIGHT_LOOP
            #pragma multi_compile_fragment _ _ADDITIONAL_LIGHT_SHADOWS
            #pragma multi_compile_fragment _ _SHADOWS_SOFT
            #pragma multi_compile_fog
            #pragma multi_compile_instancing
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"

            struct Attributes
            {
                float4 position : POSITION;
                float3 normal : NORMAL;
                float2 uv : TEXCOORD0;
                half4 colour : COLOR;
                UNITY_VERTEX_INPUT_INSTANCE_ID
            };

            struct Varyings
            {
                float4 position : SV_POSITION;
                float2 uv : TEXCOORD0;
                float3 normal : TEXCOORD1;
                float3 place : TEXCOORD2;
                half4 colour : TEXCOORD3;
                half fog : TEXCOORD4;
                UNITY_VERTEX_OUTPUT_STEREO
            };

            Varyings Vertex(Attributes corner)
            {
                Varyings v;
                UNITY_SETUP_INSTANCE_ID(corner);
                UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(v);
                v.place = TransformObjectToWorld(corner.position.xyz);
                v.position = TransformWorldToHClip(v.place);
                v.normal = TransformObjectToWorldNormal(corner.normal);
                v.uv = TRANSFORM_TEX(corner.uv, _MainTex);
                v.colour = corner.colour;
                v.fog = ComputeFogFactor(v.position.z);
                return v;
            }

            float3 LightOf(Light light, half3 colour, float3 normal, float3 toEye)
            {
                float3 arriving = light.color * (light.distanceAttenuation * light.shadowAttenuation);
                return AlateWingLight(colour, normal, toEye, light.direction, arriving, _Through, _Gloss, _Shine);
            }

            half4 Fragment(Varyings v) : SV_Target
            {
                UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(v);
                half4 paint = Paint(v.colour, v.uv);
                half3 colour = paint.rgb * paint.a;
                float3 toEye = GetWorldSpaceNormalizeViewDir(v.place);
                float3 normal = AlateFacing(normalize(v.normal), toEye, _Cull < 0.5);
                float3 sum = colour * lerp(SampleSH(normal), SampleSH(-normal), 0.5 * _Through);
                sum += LightOf(GetMainLight(TransformWorldToShadowCoord(v.place)), colour, normal, toEye);

                #if defined(_ADDITIONAL_LIGHTS) || defined(_FORWARD_PLUS) || defined(_CLUSTER_LIGHT_LOOP)
                InputData inputData = (InputData)0;
                inputData.positionWS = v.place;
                inputData.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(v.position);
                #if defined(_FORWARD_PLUS) || defined(_CLUSTER_LIGHT_LOOP)
                for (uint sun = 0; sun < min(URP_FP_DIRECTIONAL_LIGHTS_COUNT, MAX_VISIBLE_LIGHTS); sun++)
                {
                    sum += LightOf(GetAdditionalLight(sun, v.place, half4(1, 1, 1, 1)), colour, normal, toEye);
                }
                #endif
                uint count = GetAdditionalLightsCount();
                LIGHT_LOOP_BEGIN(count)
                    sum += LightOf(GetAdditionalLight(lightIndex, v.place, half4(1, 1, 1, 1)), colour, normal, toEye);
                LIGHT_LOOP_END
                #endif

                return half4(MixFogColor(half3(sum), half3(unity_FogColor.rgb * paint.a), v.fog), paint.a);
            }
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            ZWrite On
            ColorMask 0

            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_instancing
            #pragma multi_compile_vertex _ _CASTING_PUNCTUAL_LIGHT_SHADOW
            #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl"

            float3 _LightDirection;
            float3 _LightPosition;

            struct Attributes
            {
                float4 position : POSITION;
                float3 normal : NORMAL;
                float2 uv : TEXCOORD0;
                half4 colour : COLOR;
                UNITY_VERTEX_INPUT_INSTANCE_ID
            };

            struct Varyings
            {
                float4 position : SV_POSITION;
                float2 uv : TEXCOORD0;
                half4 colour : TEXCOORD1;
            };

            Varyings Vertex(Attributes corner)
            {
                Varyings v;
                UNITY_SETUP_INSTANCE_ID(corner);
                float3 place = TransformObjectToWorld(corner.position.xyz);
                float3 normal = TransformObjectToWorldNormal(corner.normal);
                #if _CASTING_PUNCTUAL_LIGHT_SHADOW
                float3 toLight = normalize(_LightPosition - place);
                #else
                float3 toLight = _LightDirection;
                #endif

                // A wing lit from below is lit: the bias must lead away from the light on either side.
                normal = _Cull < 0.5 && dot(normal, toLight) < 0 ? -normal : normal;
                v.position = TransformWorldToHClip(ApplyShadowBias(place, normal, toLight));
                #if UNITY_REVERSED_Z
                v.position.z = min(v.position.z, UNITY_NEAR_CLIP_VALUE);
                #else
                v.position.z = max(v.position.z, UNITY_NEAR_CLIP_VALUE);
                #endif
                v.uv = TRANSFORM_TEX(corner.uv, _MainTex);
                v.colour = corner.colour;
                return v;
            }

            half4 Fragment(Varyings v) : SV_Target
            {
                clip(AlateShadowHole(Paint(v.colour, v.uv).a, v.position.xy));
                return 0;
            }
            ENDHLSL
        }

        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            ZWrite On
            ColorMask R

            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_instancing

            struct Attributes
            {
                float4 position : POSITION;
                UNITY_VERTEX_INPUT_INSTANCE_ID
            };

            struct Varyings
            {
                float4 position : SV_POSITION;
                UNITY_VERTEX_OUTPUT_STEREO
            };

            Varyings Vertex(Attributes corner)
            {
                Varyings v;
                UNITY_SETUP_INSTANCE_ID(corner);
                UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(v);
                v.position = TransformObjectToHClip(corner.position.xyz);
                return v;
            }

            half4 Fragment(Varyings v) : SV_Target
            {
                return v.position.z;
            }
            ENDHLSL
        }
    }

    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }
        Cull [_Cull]

        CGINCLUDE
        #include "UnityCG.cginc"
        #include "Lighting.cginc"
        #include "AutoLight.cginc"
        #include "../../WingLight.hlsl"

        sampler2D _MainTex;
        float4 _MainTex_ST;
        half4 _Color;
        half _VertexColours, _Through, _Gloss, _Shine, _Cull, _Translucent;

        struct Attributes
        {
            float4 vertex : POSITION;
            float3 normal : NORMAL;
            float2 uv : TEXCOORD0;
            half4 colour : COLOR;
            UNITY_VERTEX_INPUT_INSTANCE_ID
        };

        struct Varyings
        {
            float4 pos : SV_POSITION;
            float2 uv : TEXCOORD0;
            float3 normal : TEXCOORD1;
            float3 place : TEXCOORD2;
            half4 colour : TEXCOORD3;
            UNITY_FOG_COORDS(4)
            UNITY_LIGHTING_COORDS(5, 6)
            UNITY_VERTEX_OUTPUT_STEREO
        };

        half4 Paint(half4 vertexColour, float2 uv)
        {
            #ifndef UNITY_COLORSPACE_GAMMA
            vertexColour.rgb = GammaToLinearSpace(vertexColour.rgb);
            #endif
            half4 paint = tex2D(_MainTex, uv) * _Color * lerp(half4(1, 1, 1, 1), vertexColour, _VertexColours);
            paint.a = lerp(1, paint.a, _Translucent);
            return paint;
        }

        Varyings ToVaryings(Attributes v)
        {
            Varyings o;
            UNITY_INITIALIZE_OUTPUT(Varyings, o);
            UNITY_SETUP_INSTANCE_ID(v);
            UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);
            o.pos = UnityObjectToClipPos(v.vertex);
            o.place = mul(unity_ObjectToWorld, v.vertex).xyz;
            o.normal = UnityObjectToWorldNormal(v.normal);
            o.uv = TRANSFORM_TEX(v.uv, _MainTex);
            o.colour = v.colour;
            UNITY_TRANSFER_FOG(o, o.pos);
            UNITY_TRANSFER_LIGHTING(o, v.uv);
            return o;
        }

        // Of the one light that the pass is for.
        float3 LightOf(Varyings i, half3 colour, float3 normal, float3 toEye)
        {
            UNITY_LIGHT_ATTENUATION(share, i, i.place);
            float3 toLight = normalize(UnityWorldSpaceLightDir(i.place));
            return AlateWingLight(colour, normal, toEye, toLight, _LightColor0.rgb * share, _Through, _Gloss, _Shine);
        }
        ENDCG

        Pass
        {
            Name "ForwardBase"
            Tags { "LightMode" = "ForwardBase" }
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]

            CGPROGRAM
            #pragma target 3.0
            #pragma vertex ToVaryings
            #pragma fragment Fragment
            #pragma multi_compile_fwdbase
            #pragma multi_compile_fog
            #pragma multi_compile_instancing

            half4 Fragment(Varyings i) : SV_Target
            {
                UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i);
                half4 paint = Paint(i.colour, i.uv);
                half3 colour = paint.rgb * paint.a;
                float3 toEye = normalize(UnityWorldSpaceViewDir(i.place));
                float3 normal = AlateFacing(normalize(i.normal), toEye, _Cull < 0.5);
                float3 sum = colour * lerp(ShadeSH9(half4(normal, 1)), ShadeSH9(half4(-normal, 1)), 0.5 * _Through);
                sum += LightOf(i, colour, normal, toEye);
                UNITY_APPLY_FOG_COLOR(i.fogCoord, sum, unity_FogColor * paint.a);
                return half4(sum, paint.a);
            }
            ENDCG
        }

        Pass
        {
            Name "ForwardAdd"
            Tags { "LightMode" = "ForwardAdd" }
            Blend One One
            ZWrite Off

            CGPROGRAM
            #pragma target 3.0
            #pragma vertex ToVaryings
            #pragma fragment Fragment
            #pragma multi_compile_fwdadd_fullshadows
            #pragma multi_compile_fog
            #pragma multi_compile_instancing

            half4 Fragment(Varyings i) : SV_Target
            {
                UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i);
                half4 paint = Paint(i.colour, i.uv);
                float3 toEye = normalize(UnityWorldSpaceViewDir(i.place));
                float3 normal = AlateFacing(normalize(i.normal), toEye, _Cull < 0.5);
                float3 sum = LightOf(i, paint.rgb * paint.a, normal, toEye);
                UNITY_APPLY_FOG_COLOR(i.fogCoord, sum, half4(0, 0, 0, 0));
                return half4(sum, 0);
            }
            ENDCG
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            ZWrite On

            CGPROGRAM
            #pragma target 3.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_shadowcaster
            #pragma multi_compile_instancing

            struct Shadow
            {
                V2F_SHADOW_CASTER;
                float2 uv : TEXCOORD1;
                half4 colour : TEXCOORD2;
                UNITY_VERTEX_OUTPUT_STEREO
            };

            Shadow Vertex(Attributes v)
            {
                Shadow o;
                UNITY_INITIALIZE_OUTPUT(Shadow, o);
                UNITY_SETUP_INSTANCE_ID(v);
                UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);

                // A wing lit from below is lit: the bias must lead away from the light on either side.
                float3 toLight = UnityWorldSpaceLightDir(mul(unity_ObjectToWorld, v.vertex).xyz);
                v.normal = _Cull < 0.5 && dot(UnityObjectToWorldNormal(v.normal), toLight) < 0 ? -v.normal : v.normal;
                TRANSFER_SHADOW_CASTER_NORMALOFFSET(o)
                o.uv = TRANSFORM_TEX(v.uv, _MainTex);
                o.colour = v.colour;
                return o;
            }

            float4 Fragment(Shadow i) : SV_Target
            {
                clip(AlateShadowHole(Paint(i.colour, i.uv).a, i.pos.xy));
                SHADOW_CASTER_FRAGMENT(i)
            }
            ENDCG
        }
    }

    Fallback Off
}
