using System.Net.WebSockets;
using System.Threading;
using System.Threading.Tasks;

namespace Alate.Cli;

/// <summary>The page on which a sample scene plays: one at a time, as there is one play mode.</summary>
/// <param name="scene">Sample that the page shows first.</param>
internal sealed class SampleView(SampleScene scene) : IServedView
{
    private readonly SemaphoreSlim m_Place = new(1);
    private SimulationThread m_Simulation;
    private CancellationToken m_Stop;
    private Task<LiveSample> m_First;

    /// <summary>Time that a page waits for another one to leave: one that is loaded again waits for itself.</summary>
    public TimeSpan Patience { get; init; } = TimeSpan.FromSeconds(3);

    public PageKind Kind => PageKind.Scene;

    public InsectDefinition First => null;

    public void Begin(SimulationThread simulation, CancellationToken stop)
    {
        (m_Simulation, m_Stop) = (simulation, stop);
        m_First = Play();
    }

    public async Task Serve(PageSocket socket, CancellationToken stop)
    {
        if (!await m_Place.WaitAsync(Patience, stop))
        {
            await socket.Close(WebSocketCloseStatus.PolicyViolation, "The scene plays on another page; close that one first.");
            return;
        }

        try
        {
            await using var session = new SampleSession(socket, m_Simulation, Interlocked.Exchange(ref m_First, null) ?? Play());
            await session.Run(stop);
        }
        finally
        {
            m_Place.Release();
        }
    }

    public async Task End()
    {
        if (Interlocked.Exchange(ref m_First, null) is not { } first)
            return;
        try
        {
            LiveSample made = await first;
            await m_Simulation.Do(made.Dispose);
        }
        catch (OperationCanceledException)
        {
            // It was not made.
        }
    }

    private Task<LiveSample> Play() => m_Simulation.Do(() =>
    {
        m_Stop.ThrowIfCancellationRequested();
        return new LiveSample(scene);
    });
}
