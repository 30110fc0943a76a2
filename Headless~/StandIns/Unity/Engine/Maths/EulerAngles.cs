using System;

namespace UnityEngine;

/// <summary>The angles behind a rotation in the order of Unity's inspector: about z first, then x, then y.</summary>
internal static class EulerAngles
{
    private const float k_Pole = 0.4999995f;

    /// <summary>Degrees, 0 to 360. At the poles (x = ±90) z is 0.</summary>
    public static Vector3 From(Quaternion rotation)
    {
        var q = Quaternion.Normalize(rotation);
        float pole = q.w * q.x - q.y * q.z;
        if (MathF.Abs(pole) > k_Pole)
            return Degrees(MathF.CopySign(MathF.PI / 2f, pole), 2f * MathF.Atan2(q.y, q.w), 0f);

        return Degrees(
            MathF.Asin(Mathf.Clamp(2f * pole, -1f, 1f)),
            MathF.Atan2(2f * (q.w * q.y + q.x * q.z), 1f - 2f * (q.x * q.x + q.y * q.y)),
            MathF.Atan2(2f * (q.w * q.z + q.x * q.y), 1f - 2f * (q.x * q.x + q.z * q.z)));
    }

    private static Vector3 Degrees(float x, float y, float z) => new(Positive(x), Positive(y), Positive(z));

    private static float Positive(float radians)
    {
        float degrees = radians * Mathf.Rad2Deg;
        if (degrees < -0.0001f)
            degrees += 360f;
        return degrees >= 360f - 0.0001f ? degrees - 360f : degrees;
    }
}
