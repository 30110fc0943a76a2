using System.Net.WebSockets;
using System.Threading;
using System.Threading.Channels;
using System.Threading.Tasks;

namespace Alate.Cli;

/// <summary>The page on which a sample plays: its requests come in, and states and the panel of the sample go out.</summary>
internal sealed class SampleSession(PageSocket socket, SimulationThread simulation, Task<LiveSample> sample) : IAsyncDisposable
{
    private const int k_Waiting = 64, k_StatesPerPanel = 6;

    private readonly Channel<SampleRequest> m_Requests = Channel.CreateBounded<SampleRequest>(k_Waiting);
    private readonly StateBuffer m_State = new();
    private LiveSample m_Sample;

    /// <summary>Serves the page until it leaves, breaks the rules, or the server stops.</summary>
    public Task Run(CancellationToken stop) => socket.Talk(Send, Take, stop);

    public async ValueTask DisposeAsync()
    {
        if (m_Sample != null)
            await simulation.Do(m_Sample.Dispose);
    }

    private async Task Send(CancellationToken stop)
    {
        m_Sample = await sample;
        await socket.Send(m_Sample.Hello(), stop);
        using var timer = new PeriodicTimer(TimeSpan.FromSeconds(1.0 / LiveSample.Rate));
        for (int state = 0; await timer.WaitForNextTickAsync(stop); state++)
        {
            while (m_Requests.Reader.TryRead(out SampleRequest next))
                await Answer(next, stop);
            if (m_Sample.IsAhead)
                continue;
            await simulation.Do(() => m_Sample.Advance(m_State));
            await socket.Send(m_State.Content, stop);
            if (state % k_StatesPerPanel == 0 && await simulation.Do(m_Sample.ChangedPanel) is { } panel)
                await socket.Send(panel, stop);
        }
    }

    private async Task Answer(SampleRequest request, CancellationToken stop)
    {
        try
        {
            if (request.Scene == null)
            {
                await simulation.Do(() => m_Sample.Change(request));
                return;
            }

            var other = SampleScene.Find(request.Scene);
            await simulation.Do(() =>
            {
                m_Sample.Dispose();
                m_Sample = null;
                m_Sample = new LiveSample(other);
            });
            await socket.Send(m_Sample.Hello(), stop);
        }
        catch (UserException problem)
        {
            await socket.Send(problem, stop);
        }
    }

    private async Task<bool> Take(WebSocketMessageType type, byte[] content, CancellationToken stop)
    {
        if (type == WebSocketMessageType.Binary)
            throw new FormatException("This page takes no files.");
        await m_Requests.Writer.WriteAsync(SampleRequest.Read(content), stop);
        return true;
    }
}
