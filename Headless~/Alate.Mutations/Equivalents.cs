using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Mutations.Sources;

namespace Alate.Mutations;

/// <summary>
/// Mutants that change nothing that can be seen, with the reasons. They are known by file, operator, change and line of source, so that
/// they stand when lines move.
/// </summary>
internal sealed class Equivalents
{
    private readonly Dictionary<(string File, string Change, string Line), string> m_Reasons = [];

    /// <exception cref="FormatException">A block is not four lines as they should be.</exception>
    public Equivalents(string file)
    {
        IEnumerable<string> lines = File.ReadLines(file).Select(line => line.Trim()).Where(line => line.Length > 0 && line[0] != '#');
        foreach (string[] block in lines.Chunk(4))
        {
            bool whole = block.Length == 4
                && block[2].StartsWith("in: ", StringComparison.Ordinal) && block[3].StartsWith("because: ", StringComparison.Ordinal);
            if (!whole)
                throw new FormatException($"{file}: a block is a file, a change, \"in:\" and \"because:\"; \"{block[0]}\" begins another.");
            m_Reasons[(block[0], block[1], block[2]["in: ".Length..])] = block[3]["because: ".Length..];
        }
    }

    /// <summary>Why a mutant is equivalent; null if it is not known to be.</summary>
    public string Reason(Mutant mutant) =>
        m_Reasons.GetValueOrDefault((mutant.File, mutant.Title, mutant.Text));
}
