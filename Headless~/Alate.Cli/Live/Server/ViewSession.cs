using System.Net.WebSockets;
using System.Threading;
using System.Threading.Channels;
using System.Threading.Tasks;

namespace Alate.Cli;

/// <summary>One page that is open: its requests come in and the states of its insect go out over one web socket.</summary>
internal sealed class ViewSession(PageSocket socket, SimulationThread simulation, Task<SceneInsect> insect) : IAsyncDisposable
{
    /// <summary>Longest files of one message together, bytes.</summary>
    public const int LongestFiles = 2 * PageSocket.LongestFile;

    private const int k_Waiting = 16;

    private readonly Channel<(ViewRequest Request, List<DroppedFile> Files)> m_Requests =
        Channel.CreateBounded<(ViewRequest, List<DroppedFile>)>(k_Waiting);
    private readonly StateBuffer m_State = new();
    private SceneInsect m_Insect;

    /// <summary>Serves the page until it leaves, breaks the rules, or the server stops.</summary>
    public async Task Run(CancellationToken stop)
    {
        using var end = CancellationTokenSource.CreateLinkedTokenSource(stop);
        Task receiving = Receive(end);
        try
        {
            m_Insect = await insect;
            await socket.Send(await simulation.Do(() => SceneMessage.Hello(m_Insect.Known, ViewSlider.All)), end.Token);
            await socket.Send(m_Insect.Scene, end.Token);
            using var timer = new PeriodicTimer(TimeSpan.FromSeconds(1.0 / SceneInsect.Rate));
            while (await timer.WaitForNextTickAsync(end.Token))
            {
                while (m_Requests.Reader.TryRead(out (ViewRequest Request, List<DroppedFile> Files) next))
                    await Answer(next.Request, next.Files, end.Token);
                await simulation.Do(() => m_Insect.Advance(m_State));
                await socket.Send(m_State.Content, end.Token);
            }
        }
        catch (Exception problem) when (PageSocket.IsGone(problem))
        {
            // The page is gone, or the server stops.
        }
        finally
        {
            await end.CancelAsync();
            await receiving;
            await socket.Close(WebSocketCloseStatus.NormalClosure, "The server stops.");
        }
    }

    public async ValueTask DisposeAsync()
    {
        if (m_Insect != null)
            await simulation.Do(m_Insect.Dispose);
    }

    private async Task Answer(ViewRequest request, List<DroppedFile> files, CancellationToken stop)
    {
        try
        {
            if (files.Count > 0)
            {
                await Take(files, stop);
            }
            else if (request.IsSave)
            {
                await socket.Send(await simulation.Do(m_Insect.Save), stop);
            }
            else
            {
                await socket.Send(
                    await simulation.Do(() => m_Insect.Change(request)) ? m_Insect.Scene : SceneMessage.Settings(m_Insect.Settings), stop);
            }
        }
        catch (UserException problem)
        {
            await socket.Send(problem, stop);
        }
    }

    // An insect file with what it names, or one wing.
    private async Task Take(List<DroppedFile> files, CancellationToken stop)
    {
        if (DroppedInsect.Find(files) is { } insect)
        {
            await simulation.Do(() => m_Insect.Add(insect, files));
            await socket.Send(await simulation.Do(() => SceneMessage.Hello(m_Insect.Known, ViewSlider.All)), stop);
        }
        else if (files.Count == 1)
        {
            await simulation.Do(() => m_Insect.Wear(files[0].Name, files[0].Content));
        }
        else
        {
            throw new UserException($"Drop one wing, or one insect file (NAME{InsectFile.Ending}) with the files that it names.");
        }

        await socket.Send(m_Insect.Scene, stop);
    }

    private async Task Receive(CancellationTokenSource end)
    {
        try
        {
            ViewRequest waiting = null;
            var files = new List<DroppedFile>();
            while (await socket.Read(end.Token) is (WebSocketMessageType type, byte[] content))
            {
                if (type == WebSocketMessageType.Binary)
                {
                    if (waiting == null)
                        throw new FormatException("A file comes behind a message that names it.");
                    files.Add(new DroppedFile(waiting.Files[files.Count], content));
                    if (files.Sum(file => (long)file.Content.Length) > LongestFiles)
                    {
                        await socket.Close(WebSocketCloseStatus.MessageTooBig, $"At most {LongestFiles} bytes of files.");
                        return;
                    }

                    if (files.Count < waiting.Files.Count)
                        continue;
                    await m_Requests.Writer.WriteAsync((waiting, files), end.Token);
                    (waiting, files) = (null, []);
                    continue;
                }

                var request = ViewRequest.Read(content);
                if (request.Files.Count > 0)
                    (waiting, files) = (request, []);
                else
                    await m_Requests.Writer.WriteAsync((request, []), end.Token);
            }
        }
        catch (FormatException problem)
        {
            await socket.Close(WebSocketCloseStatus.InvalidPayloadData, problem.Message);
        }
        catch (Exception problem) when (PageSocket.IsGone(problem))
        {
            // The page is gone, or the server stops.
        }
        finally
        {
            await end.CancelAsync();
        }
    }
}
