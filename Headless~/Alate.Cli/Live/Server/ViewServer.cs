using System.Net;
using System.Net.Sockets;
using System.Threading;
using System.Threading.Tasks;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Hosting.Server;
using Microsoft.AspNetCore.Hosting.Server.Features;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Server.Kestrel.Core;
using Microsoft.Extensions.DependencyInjection;

namespace Alate.Cli;

/// <summary>
/// Serves the live view to browsers of this machine: the page's files, and a web socket for each page that is open. Listens on the loopback
/// alone, and answers only requests that name it as their host, and sockets that its own page opened.
/// </summary>
internal sealed class ViewServer
{
    /// <summary>Port that is taken where none is named.</summary>
    public const int DefaultPort = 5180;

    /// <summary>Pages that fly at one time, and connections of any kind.</summary>
    public const int MostPages = 8, MostConnections = 64;

    private const int k_LongestRequest = 8192;
    private static readonly TimeSpan s_Idle = TimeSpan.FromSeconds(10), s_Headers = TimeSpan.FromSeconds(3);

    private readonly WebApplication m_Application;
    private readonly PageFiles m_Files;
    private readonly IServedView m_View;
    private readonly CancellationTokenSource m_Stop = new();
    private string[] m_Hosts = [];
    private int m_Pages;

    private ViewServer(IServedView view, int port, ThreeSource three)
    {
        m_View = view;
        m_Files = new PageFiles(three, view.Kind, view.First);

        // Nothing is read from the surroundings: neither files of settings nor environment variables can make it listen elsewhere.
        WebApplicationBuilder builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder.WebHost.UseKestrelCore().ConfigureKestrel(options => Limit(options, port));
        m_Application = builder.Build();
        m_Application.UseWebSockets(new WebSocketOptions { KeepAliveInterval = s_Idle, KeepAliveTimeout = s_Idle });
        m_Application.Run(Answer);
    }

    /// <summary>Address of the page.</summary>
    public Uri Address { get; private set; }

    /// <summary>Thread of what all pages show; whoever starts a server gives it one.</summary>
    public SimulationThread Simulation { get; } = new();

    /// <summary>Pages that are open.</summary>
    public int Pages => m_Pages;

    /// <summary>Starts a server.</summary>
    /// <param name="view">What its pages show.</param>
    /// <param name="port">0 for any that is free.</param>
    /// <param name="three">Where three.js is.</param>
    /// <exception cref="UserException">The port is taken or not allowed.</exception>
    public static async Task<ViewServer> Start(IServedView view, int port, ThreeSource three)
    {
        var server = new ViewServer(view, port, three);
        try
        {
            await server.m_Application.StartAsync();
        }
        catch (Exception problem) when (problem is IOException or SocketException)
        {
            await server.Stop();
            throw new UserException(
                $"Cannot listen on port {port}: {(problem.InnerException ?? problem).Message.TrimEnd('.')}. Choose another with --port; 0 "
                + "is any that is free.");
        }

        IServer kestrel = server.m_Application.Services.GetRequiredService<IServer>();
        server.Address = new Uri(kestrel.Features.Get<IServerAddressesFeature>().Addresses.First());
        server.m_Hosts = [$"127.0.0.1:{server.Address.Port}", $"localhost:{server.Address.Port}"];
        view.Begin(server.Simulation, server.m_Stop.Token);
        return server;
    }

    /// <summary>Ends what all pages show and stops listening.</summary>
    public async Task Stop()
    {
        await m_Stop.CancelAsync();
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(2));
        await m_Application.StopAsync(patience.Token);
        while (Volatile.Read(ref m_Pages) > 0)
            await Task.Delay(5);
        await m_View.End();
        await m_Application.DisposeAsync();
        m_Stop.Dispose();
    }

    private static void Limit(KestrelServerOptions options, int port)
    {
        options.AddServerHeader = false;
        options.Limits.MaxConcurrentConnections = MostConnections;
        options.Limits.MaxConcurrentUpgradedConnections = MostConnections;
        options.Limits.MaxRequestBodySize = 0;
        options.Limits.MaxRequestLineSize = k_LongestRequest;
        options.Limits.MaxRequestHeadersTotalSize = 2 * k_LongestRequest;
        options.Limits.KeepAliveTimeout = s_Idle;
        options.Limits.RequestHeadersTimeout = s_Headers;
        options.Listen(IPAddress.Loopback, port, listen => listen.Protocols = HttpProtocols.Http1);
    }

    private Task Answer(HttpContext context)
    {
        HttpResponse response = context.Response;
        response.Headers.ContentSecurityPolicy = m_Files.SecurityPolicy;
        response.Headers.XContentTypeOptions = "nosniff";
        response.Headers["Referrer-Policy"] = "no-referrer";
        response.Headers["Cross-Origin-Resource-Policy"] = "same-origin";
        response.Headers.CacheControl = "no-store";

        // Another site's name that leads here (DNS rebinding) stands in the host.
        if (!m_Hosts.Contains(context.Request.Host.Value, StringComparer.OrdinalIgnoreCase))
            return Refuse(response, StatusCodes.Status403Forbidden, "This server answers to its own address only.");
        if (!HttpMethods.IsGet(context.Request.Method) && !HttpMethods.IsHead(context.Request.Method))
            return Refuse(response, StatusCodes.Status405MethodNotAllowed, "Only GET.");
        string name = context.Request.Path.Value.TrimStart('/');
        if (name == "live")
            return Serve(context);
        byte[] file = m_Files.Find(name.Length == 0 ? PageFiles.Index : name);
        if (file == null)
            return Refuse(response, StatusCodes.Status404NotFound, "There is no such file.");
        response.ContentType = PageFiles.TypeOf(name.Length == 0 ? PageFiles.Index : name);
        response.ContentLength = file.Length;
        return HttpMethods.IsHead(context.Request.Method) ? Task.CompletedTask : response.Body.WriteAsync(file, 0, file.Length);
    }

    private async Task Serve(HttpContext context)
    {
        if (!context.WebSockets.IsWebSocketRequest)
        {
            await Refuse(context.Response, StatusCodes.Status400BadRequest, "This address is a web socket's.");
            return;
        }

        string origin = context.Request.Headers.Origin.ToString();
        if (!m_Hosts.Any(host => string.Equals(origin, "http://" + host, StringComparison.OrdinalIgnoreCase)))
        {
            await Refuse(context.Response, StatusCodes.Status403Forbidden, "Only this server's own page may open its socket.");
            return;
        }

        int pages = Interlocked.Increment(ref m_Pages);
        try
        {
            if (pages > MostPages)
            {
                await Refuse(context.Response, StatusCodes.Status503ServiceUnavailable, $"{MostPages} pages are open already.");
                return;
            }

            using var end = CancellationTokenSource.CreateLinkedTokenSource(m_Stop.Token, context.RequestAborted);
            using var socket = new PageSocket(await context.WebSockets.AcceptWebSocketAsync());
            await m_View.Serve(socket, end.Token);
        }
        finally
        {
            Interlocked.Decrement(ref m_Pages);
        }
    }

    private static Task Refuse(HttpResponse response, int status, string reason)
    {
        response.StatusCode = status;
        response.ContentType = "text/plain; charset=utf-8";
        return response.WriteAsync(reason + "\n");
    }
}
