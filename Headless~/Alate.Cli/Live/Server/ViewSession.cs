using System.Net.WebSockets;
using System.Text.Json.Nodes;
using System.Threading;
using System.Threading.Channels;
using System.Threading.Tasks;

namespace Alate.Cli;

/// <summary>One page that is open: its requests come in and the states of its insect go out over one web socket.</summary>
internal sealed class ViewSession(WebSocket socket, SimulationThread simulation, Task<SceneInsect> insect) : IAsyncDisposable
{
    /// <summary>Longest message of text, longest file, and longest files of one message together, bytes.</summary>
    public const int LongestText = 4096, LongestFile = 16 << 20, LongestFiles = 2 * LongestFile;

    private const int k_Waiting = 16, k_Chunk = 1 << 16;

    /// <summary>Longest reason for an end, bytes of UTF-8: the frame of a web socket has room for 125, two of them for the code.</summary>
    private const int k_LongestReason = 123;

    private static readonly TimeSpan s_Patience = TimeSpan.FromSeconds(20), s_Farewell = TimeSpan.FromSeconds(1);

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
            await Send(await simulation.Do(() => SceneMessage.Hello(m_Insect.Known, ViewSlider.All)), end.Token);
            await Send(m_Insect.Scene, end.Token);
            using var timer = new PeriodicTimer(TimeSpan.FromSeconds(1.0 / SceneInsect.Rate));
            while (await timer.WaitForNextTickAsync(end.Token))
            {
                while (m_Requests.Reader.TryRead(out (ViewRequest Request, List<DroppedFile> Files) next))
                    await Answer(next.Request, next.Files, end.Token);
                await simulation.Do(() => m_Insect.Advance(m_State));
                await Send(m_State.Content, WebSocketMessageType.Binary, end.Token);
            }
        }
        catch (Exception problem) when (problem is OperationCanceledException or WebSocketException or IOException)
        {
            // The page is gone, or the server stops.
        }
        finally
        {
            await end.CancelAsync();
            await receiving;
            await Close(WebSocketCloseStatus.NormalClosure, "The server stops.");
        }
    }

    public async ValueTask DisposeAsync()
    {
        if (m_Insect != null)
            await simulation.Do(m_Insect.Dispose);
        socket.Dispose();
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
                await Send(await simulation.Do(m_Insect.Save), WebSocketMessageType.Binary, stop);
            }
            else
            {
                await Send(
                    await simulation.Do(() => m_Insect.Change(request)) ? m_Insect.Scene : SceneMessage.Settings(m_Insect.Settings), stop);
            }
        }
        catch (UserException problem)
        {
            await Send(new JsonObject { ["type"] = "error", ["message"] = problem.Message.ReplaceLineEndings(" ") }, stop);
        }
    }

    // An insect file with what it names, or one wing.
    private async Task Take(List<DroppedFile> files, CancellationToken stop)
    {
        if (DroppedInsect.Find(files) is { } insect)
        {
            await simulation.Do(() => m_Insect.Add(insect, files));
            await Send(await simulation.Do(() => SceneMessage.Hello(m_Insect.Known, ViewSlider.All)), stop);
        }
        else if (files.Count == 1)
        {
            await simulation.Do(() => m_Insect.Wear(files[0].Name, files[0].Content));
        }
        else
        {
            throw new UserException($"Drop one wing, or one insect file (NAME{InsectFile.Ending}) with the files that it names.");
        }

        await Send(m_Insect.Scene, stop);
    }

    private async Task Receive(CancellationTokenSource end)
    {
        try
        {
            ViewRequest waiting = null;
            var files = new List<DroppedFile>();
            while (await ReadMessage(end.Token) is (WebSocketMessageType type, byte[] content))
            {
                if (type == WebSocketMessageType.Binary)
                {
                    if (waiting == null)
                        throw new FormatException("A file comes behind a message that names it.");
                    files.Add(new DroppedFile(waiting.Files[files.Count], content));
                    if (files.Sum(file => (long)file.Content.Length) > LongestFiles)
                    {
                        await Close(WebSocketCloseStatus.MessageTooBig, $"At most {LongestFiles} bytes of files.");
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
            await Close(WebSocketCloseStatus.InvalidPayloadData, problem.Message);
        }
        catch (Exception problem) when (problem is OperationCanceledException or WebSocketException or IOException)
        {
            // The page is gone, or the server stops.
        }
        finally
        {
            await end.CancelAsync();
        }
    }

    // Null where the page says goodbye or says too much.
    private async Task<(WebSocketMessageType, byte[])?> ReadMessage(CancellationToken stop)
    {
        byte[] chunk = new byte[k_Chunk];
        using var content = new MemoryStream();
        while (true)
        {
            ValueWebSocketReceiveResult part = await socket.ReceiveAsync(chunk.AsMemory(), stop);
            if (part.MessageType == WebSocketMessageType.Close)
                return null;
            int most = part.MessageType == WebSocketMessageType.Text ? LongestText : LongestFile;
            if (content.Length + part.Count > most)
            {
                await Close(WebSocketCloseStatus.MessageTooBig, $"At most {most} bytes.");
                return null;
            }

            content.Write(chunk, 0, part.Count);
            if (part.EndOfMessage)
                return (part.MessageType, content.ToArray());
        }
    }

    private Task Send(JsonObject message, CancellationToken stop) =>
        Send(Encoding.UTF8.GetBytes(message.ToJsonString()), WebSocketMessageType.Text, stop);

    // A page that does not read must not hold the insect for ever.
    private async Task Send(ReadOnlyMemory<byte> content, WebSocketMessageType type, CancellationToken stop)
    {
        using var patience = CancellationTokenSource.CreateLinkedTokenSource(stop);
        patience.CancelAfter(s_Patience);
        await socket.SendAsync(content, type, true, patience.Token);
    }

    private async Task Close(WebSocketCloseStatus status, string reason)
    {
        using var patience = new CancellationTokenSource(s_Farewell);
        try
        {
            if (socket.State is WebSocketState.Open or WebSocketState.CloseReceived)
                await socket.CloseOutputAsync(status, QuotedMessage.Bytes(reason, k_LongestReason), patience.Token);
        }
        catch (Exception problem) when (problem is OperationCanceledException or WebSocketException or IOException
            or InvalidOperationException)
        {
            socket.Abort();
        }
    }
}
