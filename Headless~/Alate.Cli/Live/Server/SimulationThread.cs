using System.Collections.Concurrent;
using System.Threading.Tasks;

namespace Alate.Cli;

/// <summary>
/// Lets the many threads of a server use the simulation, which belongs to one thread: that one does their work in the order in which it
/// comes.
/// </summary>
internal sealed class SimulationThread
{
    private readonly BlockingCollection<Action> m_Work = [];

    /// <summary>Queues work for the simulation's thread.</summary>
    /// <returns>Ends when it is done, with its exception if there is one.</returns>
    public Task<T> Do<T>(Func<T> work)
    {
        var done = new TaskCompletionSource<T>(TaskCreationOptions.RunContinuationsAsynchronously);
        m_Work.Add(() =>
        {
            try
            {
                done.SetResult(work());
            }
            catch (Exception problem)
            {
                done.SetException(problem);
            }
        });
        return done.Task;
    }

    /// <inheritdoc cref="Do{T}(Func{T})"/>
    public Task Do(Action work) => Do(() =>
    {
        work();
        return true;
    });

    /// <summary>Makes the calling thread the simulation's, until a task has ended.</summary>
    public void RunUntil(Task end)
    {
        end.ContinueWith(_ => m_Work.Add(() => { }), TaskScheduler.Default);
        while (!end.IsCompleted)
            m_Work.Take()();
    }
}
