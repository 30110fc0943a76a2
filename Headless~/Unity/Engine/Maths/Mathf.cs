using System;

namespace UnityEngine;

public struct Mathf
{
    public const float PI = MathF.PI;
    public const float Rad2Deg = 57.29578f;
    public const float Deg2Rad = 0.0174532924f;

    public static float Sin(float f) => MathF.Sin(f);
    public static float Cos(float f) => MathF.Cos(f);
    public static float Sqrt(float f) => MathF.Sqrt(f);
    public static float Pow(float f, float p) => MathF.Pow(f, p);
    public static float Abs(float f) => MathF.Abs(f);
    public static float Min(float a, float b) => a < b ? a : b;
    public static float Max(float a, float b) => a > b ? a : b;
    public static float Clamp(float value, float min, float max) => value < min ? min : value > max ? max : value;
    public static float Clamp01(float value) => Clamp(value, 0f, 1f);
    public static float Lerp(float a, float b, float t) => a + (b - a) * Clamp01(t);
}
