using System;
using System.Collections.Generic;
using System.Linq;

namespace Alate.Mutations.Sources;

/// <summary>
/// Mutants drawn at random: as many of each room as of the others, and in a room of each operator, so that the many constants do not
/// hide the few units.
/// </summary>
internal sealed class Sample
{
    private readonly Dictionary<string, Queue<Mutant>> m_Rooms;

    /// <param name="candidates">Mutants by room, in an order that does not change from run to run.</param>
    public Sample(IEnumerable<(string Room, Mutant Mutant)> candidates, int seed)
    {
        m_Rooms = candidates.GroupBy(candidate => candidate.Room, candidate => candidate.Mutant)
            .OrderBy(room => room.Key, StringComparer.Ordinal)
            .ToDictionary(room => room.Key, room => new Queue<Mutant>(Order(room, new Random(HashCode(room.Key) ^ seed))));
    }

    public IReadOnlyCollection<string> Rooms => m_Rooms.Keys;

    /// <summary>Mutants by room: an even share of the count, or all that a room has.</summary>
    public Dictionary<string, List<Mutant>> Draw(int count)
    {
        var drawn = m_Rooms.Keys.ToDictionary(room => room, _ => new List<Mutant>());
        for (int left = count; left > 0;)
        {
            int before = left;
            foreach (string room in m_Rooms.Keys.Where(room => m_Rooms[room].Count > 0))
            {
                if (left == 0)
                    break;
                drawn[room].Add(m_Rooms[room].Dequeue());
                left--;
            }

            if (left == before)
                break;
        }

        return drawn;
    }

    /// <summary>The next mutant of a room, in place of one that the compiler refused; null if there is none.</summary>
    public Mutant Next(string room) => m_Rooms[room].TryDequeue(out Mutant next) ? next : null;

    /// <summary>Each turn draws an operator, then one of its mutants; a line is drawn once.</summary>
    private static IEnumerable<Mutant> Order(IEnumerable<Mutant> mutants, Random random)
    {
        var left = mutants.GroupBy(mutant => mutant.Operator)
            .OrderBy(group => group.Key, StringComparer.Ordinal).Select(group => group.ToList()).ToList();
        var lines = new HashSet<(string, int)>();
        while (left.Count > 0)
        {
            List<Mutant> group = left[random.Next(left.Count)];
            int at = random.Next(group.Count);
            Mutant mutant = group[at];
            group.RemoveAt(at);
            if (group.Count == 0)
                left.Remove(group);
            if (lines.Add((mutant.File, mutant.Line)))
                yield return mutant;
        }
    }

    /// <summary>A hash that is the same in every process, unlike that of String.</summary>
    private static int HashCode(string text) => text.Aggregate(17, (hash, letter) => unchecked(hash * 31 + letter));
}
