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
    private ViewRequest m_Waiting;
    private List<DroppedFile> m_Files = [];

    /// <summary>Serves the page until it leaves, breaks the rules, or the server stops.</summary>
    public Task Run(CancellationToken stop) => socket.Talk(Send, Take, stop);

    public async ValueTask DisposeAsync()
    {
        if (m_Insect != null)
            await simulation.Do(m_Insect.Dispose);
    }

    private async Task Send(CancellationToken stop)
    {
        m_Insect = await insect;
        await socket.Send(await simulation.Do(() => SceneMessage.Hello(m_Insect.Known, ViewSlider.All)), stop);
        await socket.Send(m_Insect.Scene, stop);
        using var timer = new PeriodicTimer(TimeSpan.FromSeconds(1.0 / SceneInsect.Rate));
        while (await timer.WaitForNextTickAsync(stop))
        {
            while (m_Requests.Reader.TryRead(out (ViewRequest Request, List<DroppedFile> Files) next))
                await Answer(next.Request, next.Files, stop);
            await simulation.Do(() => m_Insect.Advance(m_State));
            await socket.Send(m_State.Content, stop);
        }
    }

    private async Task Answer(ViewRequest request, List<DroppedFile> files, CancellationToken stop)
    {
        try
        {
            if (files.Count > 0)
            {
                await TakeFiles(files, stop);
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
    private async Task TakeFiles(List<DroppedFile> files, CancellationToken stop)
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

    // Files come behind the message that names them.
    private async Task<bool> Take(WebSocketMessageType type, byte[] content, CancellationToken stop)
    {
        if (type == WebSocketMessageType.Text)
        {
            var request = ViewRequest.Read(content);
            if (request.Files.Count > 0)
                (m_Waiting, m_Files) = (request, []);
            else
                await m_Requests.Writer.WriteAsync((request, []), stop);
            return true;
        }

        if (m_Waiting == null)
            throw new FormatException("A file comes behind a message that names it.");
        m_Files.Add(new DroppedFile(m_Waiting.Files[m_Files.Count], content));
        if (m_Files.Sum(file => (long)file.Content.Length) > LongestFiles)
        {
            await socket.Close(WebSocketCloseStatus.MessageTooBig, $"At most {LongestFiles} bytes of files.");
            return false;
        }

        if (m_Files.Count == m_Waiting.Files.Count)
        {
            await m_Requests.Writer.WriteAsync((m_Waiting, m_Files), stop);
            (m_Waiting, m_Files) = (null, []);
        }

        return true;
    }
}
