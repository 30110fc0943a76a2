namespace Unity.Mathematics;

/// <summary>Unity's mathematical functions: names as in HLSL, semantics as in com.unity.mathematics.</summary>
public static partial class @math
{
    public const double E_DBL = 2.71828182845904523536;
    public const double LOG2E_DBL = 1.44269504088896340736;
    public const double LOG10E_DBL = 0.434294481903251827651;
    public const double LN2_DBL = 0.693147180559945309417;
    public const double LN10_DBL = 2.30258509299404568402;
    public const double PI_DBL = 3.14159265358979323846;
    public const double SQRT2_DBL = 1.41421356237309504880;
    public const double EPSILON_DBL = 2.22044604925031308085e-16;
    public const double INFINITY_DBL = double.PositiveInfinity;
    public const double NAN_DBL = double.NaN;
    public const double DBL_MIN_NORMAL = 2.2250738585072014e-308;

    public const float E = (float)E_DBL;
    public const float LOG2E = (float)LOG2E_DBL;
    public const float LOG10E = (float)LOG10E_DBL;
    public const float LN2 = (float)LN2_DBL;
    public const float LN10 = (float)LN10_DBL;
    public const float PI = (float)PI_DBL;
    public const float SQRT2 = (float)SQRT2_DBL;
    public const float EPSILON = 1.1920928955078125e-7f;
    public const float INFINITY = float.PositiveInfinity;
    public const float NAN = float.NaN;
    public const float FLT_MIN_NORMAL = 1.175494351e-38f;
}
