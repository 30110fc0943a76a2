using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;

namespace Alate.Benchmarks;

/// <summary>
/// Checks that the hot methods are compiled without calls to members of float4, math or the four-lane types. RyuJIT inlines no more once a
/// method has 512 locals, silently, and the remaining calls make the code 10 to 47 times slower; this check works on any machine. To see
/// the code itself: <c>DOTNET_JitDisasm="Alate.DualQuaternionSkinning:*" DOTNET_JitStdOutFile=FILE</c> before the benchmark.
/// </summary>
internal static class HotCode
{
    private static readonly Type[] s_Hot =
    [
        typeof(DelayedWaves), typeof(DrivenPose), typeof(Aerodynamics), typeof(PatchAir), typeof(Coefficients), typeof(CellMotion),
        typeof(CellSheet), typeof(BilinearField), typeof(JointLoads), typeof(CarriedSurface), typeof(Bending), typeof(ChainCoupling),
        typeof(ElasticStep), typeof(ChordSolver), typeof(NewtonSolver),
        typeof(SpringEnergy), typeof(BlockCholesky), typeof(JointFrames), typeof(CellBlend), typeof(DualQuaternionSkinning),
        typeof(EightVertices), typeof(SkinPalette), typeof(AirReadings),
    ];

    private static readonly string[] s_Elementary =
    [
        "Unity.Mathematics.", "Unity.Burst.Intrinsics.", "Alate.Soa", "Alate.TwoFloat", "Alate.SymmetricBlock",
        "System.Numerics.Vector", "System.Runtime.Intrinsics.",
    ];

    public static bool IsHot(string type) => s_Hot.Any(hot => hot.FullName == type);

    public static bool IsElementary(string type) =>
        s_Elementary.Any(elementary => type.StartsWith(elementary, StringComparison.Ordinal));

    /// <summary>Compiles the hot methods, which must not have run yet, and counts the calls left in them.</summary>
    public static void Run(Report report)
    {
        using var listener = new InliningListener();
        int compiled = 0;
        foreach (MethodInfo method in s_Hot.SelectMany(Methods))
        {
            RuntimeHelpers.PrepareMethod(method.MethodHandle);
            compiled++;
        }

        listener.Settle();
        report.Figure("calls_in_hot_code", $"calls left in {compiled} hot methods", "calls", listener.Calls.Values.Sum());
        foreach ((string call, int count) in listener.Calls.OrderBy(call => call.Key, StringComparer.Ordinal))
            report.Line($"  {count} x {call}");
    }

    // Small ones that are inlined themselves do not count: they exist in their callers only.
    private static IEnumerable<MethodInfo> Methods(Type type) => type
        .GetMethods(BindingFlags.DeclaredOnly | BindingFlags.Static | BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic)
        .Where(method => (method.MethodImplementationFlags & MethodImplAttributes.AggressiveInlining) == 0);
}
