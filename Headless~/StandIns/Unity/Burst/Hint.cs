namespace Unity.Burst.CompilerServices;

public static class Hint
{
    public static bool Likely(bool condition) => condition;

    public static bool Unlikely(bool condition) => condition;

    public static void Assume(bool condition)
    {
    }
}
