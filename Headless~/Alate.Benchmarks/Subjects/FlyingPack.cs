using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>A full pack of four wings in flight with its working memory, for timing single kernels.</summary>
internal sealed unsafe class FlyingPack : IDisposable
{
    private readonly PackMemory m_Memory;
    private readonly byte* m_Scratch;

    /// <summary>The scratch as the last substep left it.</summary>
    public readonly StepScratch scratch;

    /// <summary>Length of a substep, seconds.</summary>
    public readonly float substep;

    public FlyingPack(Specimen specimen, int substeps)
    {
        ref readonly RigView rig = ref specimen.Rig.View;
        m_Memory = new PackMemory(rig, specimen.Parameters.options);
        for (int wing = 0; wing < WingPack.Lanes; wing++)
            m_Memory.Add(wing, specimen.Parameters, specimen.FlightOf(wing));

        var size = RigSize.Of(rig);
        long bytes = StepScratch.Layout(size, null, out _);
        m_Scratch = (byte*)UnsafeUtility.Malloc(bytes, 64, Allocator.Persistent);
        UnsafeUtility.MemClear(m_Scratch, bytes);
        StepScratch.Layout(size, m_Scratch, out scratch);
        PackStep.Derive(Pack);
        PackReset.Restart(Pack, scratch, true);
        substep = 1f / math.cmax(Pack.beat->frequency * Pack.parameters->numbers.substepsPerBeat);
        for (int k = 0; k < substeps; k++)
            PackStep.Substep(Pack, scratch, substep);
    }

    public ref readonly WingPack Pack => ref m_Memory.view;

    public void Dispose()
    {
        m_Memory.Dispose();
        UnsafeUtility.Free(m_Scratch, Allocator.Persistent);
    }
}
