using System.Threading;

namespace Alate.Cli;

/// <summary>Thread that steps the wakes of all flights, each a step in turn, behind the one that flies them.</summary>
internal sealed class WakeWorker
{
    private readonly Queue<LiveWake> m_Due = new();

    private WakeWorker()
    {
        var thread = new Thread(Run) { IsBackground = true, Name = "Wakes", Priority = ThreadPriority.BelowNormal };
        thread.Start();
    }

    /// <summary>The only one.</summary>
    public static WakeWorker Shared { get; } = new();

    /// <summary>Queues a wake with a step to do.</summary>
    public void Add(LiveWake wake)
    {
        lock (m_Due)
        {
            m_Due.Enqueue(wake);
            Monitor.Pulse(m_Due);
        }
    }

    private void Run()
    {
        while (true)
        {
            LiveWake wake;
            lock (m_Due)
            {
                while (m_Due.Count == 0)
                    Monitor.Wait(m_Due);
                wake = m_Due.Dequeue();
            }

            if (wake.Step())
                Add(wake);
        }
    }
}
