using System.Threading;
using System.Threading.Tasks;

namespace Alate.Cli;

/// <summary>Pages on which an insect flies, one of its own for each.</summary>
/// <param name="species">Insect that a page shows first.</param>
/// <param name="variant">Its variant.</param>
internal sealed class InsectView(InsectDefinition species, InsectVariant variant) : IServedView
{
    private SimulationThread m_Simulation;
    private CancellationToken m_Stop;
    private Task<SceneInsect> m_First;

    public PageKind Kind => PageKind.Live;

    public InsectDefinition First => species;

    // Its wings are painted while the browser starts.
    public void Begin(SimulationThread simulation, CancellationToken stop)
    {
        (m_Simulation, m_Stop) = (simulation, stop);
        m_First = MakeInsect();
    }

    public async Task Serve(PageSocket socket, CancellationToken stop)
    {
        await using var session = new ViewSession(socket, m_Simulation, Interlocked.Exchange(ref m_First, null) ?? MakeInsect());
        await session.Run(stop);
    }

    public async Task End()
    {
        if (Interlocked.Exchange(ref m_First, null) is not { } first)
            return;
        try
        {
            SceneInsect made = await first;
            await m_Simulation.Do(made.Dispose);
        }
        catch (Exception problem) when (problem is OperationCanceledException or UserException)
        {
            // It was not made.
        }
    }

    private Task<SceneInsect> MakeInsect() => m_Simulation.Do(() =>
    {
        m_Stop.ThrowIfCancellationRequested();
        return new SceneInsect(ViewSettings.Of(species, variant));
    });
}
