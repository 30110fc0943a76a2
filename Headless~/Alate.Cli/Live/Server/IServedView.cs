using System.Threading;
using System.Threading.Tasks;

namespace Alate.Cli;

/// <summary>Pages of a server: which files they have, and what is behind their web sockets.</summary>
internal interface IServedView
{
    /// <summary>Kind of the pages.</summary>
    PageKind Kind { get; }

    /// <summary>Insect that they show first; null for a scene.</summary>
    InsectDefinition First { get; }

    /// <summary>Begins what the first page shows, while the browser starts.</summary>
    /// <param name="simulation">Thread of what is shown.</param>
    /// <param name="stop">Ends it.</param>
    void Begin(SimulationThread simulation, CancellationToken stop);

    /// <summary>Serves a page until it leaves, breaks the rules, or the server stops.</summary>
    Task Serve(PageSocket socket, CancellationToken stop);

    /// <summary>Ends what no page has.</summary>
    Task End();
}
