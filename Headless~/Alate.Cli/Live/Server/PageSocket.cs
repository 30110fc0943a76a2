using System.Net.WebSockets;
using System.Text.Json.Nodes;
using System.Threading;
using System.Threading.Tasks;

namespace Alate.Cli;

/// <summary>Web socket of a page: whole messages, with limits on their lengths and on the time that a page takes to read.</summary>
internal sealed class PageSocket(WebSocket socket) : IDisposable
{
    /// <summary>Longest message of text, and longest binary one, bytes.</summary>
    public const int LongestText = 4096, LongestFile = 16 << 20;

    private const int k_Chunk = 1 << 16;

    /// <summary>Longest reason for an end, bytes of UTF-8: the frame of a web socket has room for 125, two of them for the code.</summary>
    private const int k_LongestReason = 123;

    private static readonly TimeSpan s_Patience = TimeSpan.FromSeconds(20), s_Farewell = TimeSpan.FromSeconds(1);

    /// <summary>Sends to the page and takes what it says, until it leaves or breaks the rules, or the server stops.</summary>
    /// <param name="send">Sends until its token ends.</param>
    /// <param name="take">Takes a message, and says whether the page may go on; a <see cref="FormatException"/> says why not.</param>
    /// <param name="stop">Stops both.</param>
    public async Task Talk(
        Func<CancellationToken, Task> send, Func<WebSocketMessageType, byte[], CancellationToken, Task<bool>> take, CancellationToken stop)
    {
        using var end = CancellationTokenSource.CreateLinkedTokenSource(stop);
        Task receiving = Receive(take, end);
        try
        {
            await send(end.Token);
        }
        catch (Exception problem) when (IsGone(problem))
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

    private async Task Receive(Func<WebSocketMessageType, byte[], CancellationToken, Task<bool>> take, CancellationTokenSource end)
    {
        try
        {
            while (await Read(end.Token) is (WebSocketMessageType type, byte[] content) && await take(type, content, end.Token))
            {
            }
        }
        catch (FormatException problem)
        {
            await Close(WebSocketCloseStatus.InvalidPayloadData, problem.Message);
        }
        catch (Exception problem) when (IsGone(problem))
        {
            // The page is gone, or the server stops.
        }
        finally
        {
            await end.CancelAsync();
        }
    }

    // Null where the page says goodbye or says too much.
    private async Task<(WebSocketMessageType Type, byte[] Content)?> Read(CancellationToken stop)
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

    /// <summary>Sends a message of text.</summary>
    public Task Send(JsonObject message, CancellationToken stop) =>
        Send(Encoding.UTF8.GetBytes(message.ToJsonString()), WebSocketMessageType.Text, stop);

    /// <summary>Sends a binary message.</summary>
    public Task Send(ReadOnlyMemory<byte> content, CancellationToken stop) => Send(content, WebSocketMessageType.Binary, stop);

    /// <summary>Tells the page what was wrong.</summary>
    public Task Send(UserException problem, CancellationToken stop) =>
        Send(new JsonObject { ["type"] = "error", ["message"] = problem.Message.ReplaceLineEndings(" ") }, stop);

    /// <summary>Says goodbye, with a reason.</summary>
    public async Task Close(WebSocketCloseStatus status, string reason)
    {
        using var patience = new CancellationTokenSource(s_Farewell);
        try
        {
            // Until the page answers: what ends before that, such as a message under way, may take the reason along.
            if (socket.State is WebSocketState.Open or WebSocketState.CloseReceived)
                await socket.CloseAsync(status, QuotedMessage.Bytes(reason, k_LongestReason), patience.Token);
        }
        catch (Exception problem) when (IsGone(problem) || problem is InvalidOperationException)
        {
            socket.Abort();
        }
    }

    // What reading and sending throw.
    private static bool IsGone(Exception problem) => problem is OperationCanceledException or WebSocketException or IOException;

    public void Dispose() => socket.Dispose();

    // A page that does not read must not hold the simulation for ever.
    private async Task Send(ReadOnlyMemory<byte> content, WebSocketMessageType type, CancellationToken stop)
    {
        using var patience = CancellationTokenSource.CreateLinkedTokenSource(stop);
        patience.CancelAfter(s_Patience);
        await socket.SendAsync(content, type, true, patience.Token);
    }
}
