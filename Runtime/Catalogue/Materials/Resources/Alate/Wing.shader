// Wings and bodies with vertex colours or a texture, seen from both sides, with light that shines through. Three SubShaders: URP 17.1 and newer, URP 14 to 17.0,
// and the built-in pipeline. HDRP has no SubShader here: Alate.WingMaterial takes HDRP/Lit there.
Shader "Alate/Wing"
{
    Properties
    {
        [MainTexture] _MainTex ("Texture", 2D) = "white" {}
        [MainColor] _Color ("Tint", Color) = (1, 1, 1, 1)
        _Underside ("Underside", Color) = (1, 1, 1, 0)
        [ToggleUI] _VertexColours ("Vertex Colours", Float) = 1
        _Through ("Light Through", Range(0, 1)) = 0.5
        _Gloss ("Gloss", Range(0, 1)) = 0.12
        _Shine ("Shine", Range(4, 128)) = 24
        [Enum(UnityEngine.Rendering.CullMode)] _Cull ("Cull", Float) = 0
        [ToggleUI] _Translucent ("Translucent", Float) = 0
        [Toggle(_CUT)] _Cut ("Cut", Float) = 0
        [NoScaleOffset] _BakeMap ("Baked Loops", 2D) = "black" {}
        [HideInInspector] [NoScaleOffset] _SkinMap ("Joints", 2D) = "black" {}
        [HideInInspector] _SkinLast ("Texels to the Last Joints", Float) = 0
        [HideInInspector] _SrcBlend ("Source Blend", Float) = 1
        [HideInInspector] _DstBlend ("Destination Blend", Float) = 0
        [HideInInspector] _ZWrite ("Depth Write", Float) = 1
        [HideInInspector] _AlphaToMask ("Coverage by Opacity", Float) = 0
    }

    // URP 17.1 renamed the keyword of clustered lights and warns where a shader declares the old one.
    SubShader
    {
        PackageRequirements
        {
            "com.unity.render-pipelines.universal": "17.1.0"
        }

        Tags
        {
            "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" "Queue" = "Geometry" "AlwaysRenderMotionVectors" = "true"
        }

        Cull [_Cull]

        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "UniversalForwardOnly" }
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]
            AlphaToMask [_AlphaToMask]

            HLSLPROGRAM
            #pragma target 3.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE
            #pragma multi_compile _ _ADDITIONAL_LIGHTS
            #pragma multi_compile _ _CLUSTER_LIGHT_LOOP
            #pragma multi_compile_fragment _ _ADDITIONAL_LIGHT_SHADOWS
            #pragma multi_compile_fragment _ _SHADOWS_SOFT
            #pragma multi_compile_fragment _ _LIGHT_LAYERS
            #pragma multi_compile_fog
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ _BAKED _SKINNED
            #pragma multi_compile_local _ _CUT
            #include "../../Universal/WingForward.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            ZWrite On
            ColorMask 0

            HLSLPROGRAM
            #pragma target 3.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ _BAKED _SKINNED
            #pragma multi_compile_local _ _CUT
            #pragma multi_compile_vertex _ _CASTING_PUNCTUAL_LIGHT_SHADOW
            #include "../../Universal/WingShadow.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            ZWrite On
            ColorMask R

            HLSLPROGRAM
            #pragma target 3.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ _BAKED _SKINNED
            #pragma multi_compile_local _ _CUT
            #include "../../Universal/WingDepth.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthNormalsOnly"
            Tags { "LightMode" = "DepthNormalsOnly" }
            ZWrite On

            HLSLPROGRAM
            #pragma target 3.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_fragment _ _GBUFFER_NORMALS_OCT
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ _BAKED _SKINNED
            #pragma multi_compile_local _ _CUT
            #include "../../Universal/WingDepthNormals.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "MotionVectors"
            Tags { "LightMode" = "MotionVectors" }
            ColorMask RG

            HLSLPROGRAM
            #pragma target 3.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ _BAKED _SKINNED
            #include "../../Universal/WingMotion.hlsl"
            ENDHLSL
        }
    }

    // URP 14 to 17.0 know clustered lights as Forward+. All else is as above.
    SubShader
    {
        PackageRequirements
        {
            "com.unity.render-pipelines.universal": "[14.0.0,17.1.0)"
        }

        Tags
        {
            "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" "Queue" = "Geometry" "AlwaysRenderMotionVectors" = "true"
        }

        Cull [_Cull]

        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "UniversalForwardOnly" }
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]
            AlphaToMask [_AlphaToMask]

            HLSLPROGRAM
            #pragma target 3.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE
            #pragma multi_compile _ _ADDITIONAL_LIGHTS
            #pragma multi_compile _ _FORWARD_PLUS
            #pragma multi_compile_fragment _ _ADDITIONAL_LIGHT_SHADOWS
            #pragma multi_compile_fragment _ _SHADOWS_SOFT
            #pragma multi_compile_fragment _ _LIGHT_LAYERS
            #pragma multi_compile_fog
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ _BAKED _SKINNED
            #pragma multi_compile_local _ _CUT
            #include "../../Universal/WingForward.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            ZWrite On
            ColorMask 0

            HLSLPROGRAM
            #pragma target 3.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ _BAKED _SKINNED
            #pragma multi_compile_local _ _CUT
            #pragma multi_compile_vertex _ _CASTING_PUNCTUAL_LIGHT_SHADOW
            #include "../../Universal/WingShadow.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            ZWrite On
            ColorMask R

            HLSLPROGRAM
            #pragma target 3.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ _BAKED _SKINNED
            #pragma multi_compile_local _ _CUT
            #include "../../Universal/WingDepth.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthNormalsOnly"
            Tags { "LightMode" = "DepthNormalsOnly" }
            ZWrite On

            HLSLPROGRAM
            #pragma target 3.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_fragment _ _GBUFFER_NORMALS_OCT
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ _BAKED _SKINNED
            #pragma multi_compile_local _ _CUT
            #include "../../Universal/WingDepthNormals.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "MotionVectors"
            Tags { "LightMode" = "MotionVectors" }
            ColorMask RG

            HLSLPROGRAM
            #pragma target 3.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ _BAKED _SKINNED
            #define ALATE_MOTION_BIAS
            #include "../../Universal/WingMotion.hlsl"
            ENDHLSL
        }
    }

    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }
        Cull [_Cull]

        Pass
        {
            Name "ForwardBase"
            Tags { "LightMode" = "ForwardBase" }
            Blend [_SrcBlend] [_DstBlend]
            ZWrite [_ZWrite]
            AlphaToMask [_AlphaToMask]

            CGPROGRAM
            #pragma target 3.0
            #pragma vertex ToVaryings
            #pragma fragment Fragment
            #pragma multi_compile_fwdbase
            #pragma multi_compile_fog
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ _BAKED _SKINNED
            #pragma multi_compile_local _ _CUT
            #include "../../BuiltIn/WingInput.cginc"

            half4 Fragment(Varyings i) : SV_Target
            {
                // Instanced insects each have their own ambient light.
                UNITY_SETUP_INSTANCE_ID(i);
                UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i);
                half4 paint = Paint(i.colour, i.uv);
                float3 toEye = normalize(UnityWorldSpaceViewDir(i.place));
                half3 colour = AlateSide(paint.rgb, i.normal, toEye, _Cull < 0.5, _Underside) * AlateOpaqueShare(paint.a) * AlateTint();
                float3 normal = AlateFacing(normalize(i.normal), toEye, _Cull < 0.5);
                float3 sum = colour * lerp(ShadeSH9(half4(normal, 1)), ShadeSH9(half4(-normal, 1)), 0.5 * _Through);
                sum += LightOf(i, colour, normal, toEye);
                UNITY_APPLY_FOG_COLOR(i.fogCoord, sum, unity_FogColor * AlateOpaqueShare(paint.a));
                return half4(sum, paint.a);
            }
            ENDCG
        }

        Pass
        {
            Name "ForwardAdd"
            Tags { "LightMode" = "ForwardAdd" }
            Blend One One
            AlphaToMask [_AlphaToMask]
            ZWrite Off

            CGPROGRAM
            #pragma target 3.0
            #pragma vertex ToVaryings
            #pragma fragment Fragment
            #pragma multi_compile_fwdadd_fullshadows
            #pragma multi_compile_fog
            #pragma multi_compile_instancing
            #pragma multi_compile_local _ _BAKED _SKINNED
            #pragma multi_compile_local _ _CUT
            #include "../../BuiltIn/WingInput.cginc"

            half4 Fragment(Varyings i) : SV_Target
            {
                UNITY_SETUP_INSTANCE_ID(i);
                UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i);
                half4 paint = Paint(i.colour, i.uv);
                float3 toEye = normalize(UnityWorldSpaceViewDir(i.place));
                float3 normal = AlateFacing(normalize(i.normal), toEye, _Cull < 0.5);
                half3 colour = AlateSide(paint.rgb, i.normal, toEye, _Cull < 0.5, _Underside) * AlateOpaqueShare(paint.a) * AlateTint();
                float3 sum = LightOf(i, colour, normal, toEye);
                UNITY_APPLY_FOG_COLOR(i.fogCoord, sum, half4(0, 0, 0, 0));
                #if defined(_CUT)
                return half4(sum, paint.a);
                #else
                return half4(sum, 0);
                #endif
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
            #pragma multi_compile_local _ _BAKED _SKINNED
            #pragma multi_compile_local _ _CUT
            #include "../../BuiltIn/WingInput.cginc"

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
                ALATE_SHAPE_POSITION(v, vertex)
                ALATE_SHAPE_NORMAL(v)

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

        // Unity draws its objects one by one here.
        Pass
        {
            Name "MotionVectors"
            Tags { "LightMode" = "MotionVectors" }
            ZWrite Off

            CGPROGRAM
            #pragma target 3.0
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_local _ _BAKED _SKINNED
            #include "../../BuiltIn/WingMotion.cginc"
            ENDCG
        }
    }

    Fallback Off
}
