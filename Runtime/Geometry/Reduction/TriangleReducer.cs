using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Geometry
{
    /// <summary>
    /// Takes vertices out of a surface one by one, the least missed first: a vertex moves onto a neighbour, so that those that remain are
    /// vertices of the surface and keep their places in its textures. Margins stay where they are; parts too small to matter go as a whole.
    /// </summary>
    internal sealed class TriangleReducer
    {
        /// <summary>Weight of margins; of ways to vertices that went, to spread the rest; least cosine of triangles that change.</summary>
        private const double k_Margin = 10.0, k_Way = 5e-4, k_Flip = 0.2;

        private readonly float3[] m_Places;
        private readonly List<int3> m_Triangles = new List<int3>();
        private readonly List<int> m_Parts = new List<int>();
        private readonly List<bool> m_Alive = new List<bool>();
        private readonly List<int>[] m_Around;
        private readonly Quadric[] m_Quadrics;
        private readonly bool[] m_Locked;
        private readonly (double Cost, int To)[] m_Best;
        private readonly SortedSet<(double Cost, int Vertex)> m_Queue = new SortedSet<(double, int)>();

        // Of the vertex that moves, the one it moves onto, both after a move; [vertex] the last search that met it, triangles it shares.
        private readonly List<int> m_Neighbours = new List<int>(), m_Others = new List<int>(), m_Touched = new List<int>();
        private readonly int[] m_Met, m_Shared;
        private int m_Search;

        // Of the vertex that moves: whether it is on a margin, and the areas of its triangles as they are.
        private bool m_OnMargin;
        private readonly List<float3> m_Areas = new List<float3>();

        private readonly int m_PartCount;
        private int m_Count;

        /// <param name="places">[vertex] Of the surface at rest.</param>
        /// <param name="parts">[part] Three vertices a triangle.</param>
        public TriangleReducer(float3[] places, IReadOnlyList<int[]> parts)
        {
            m_Places = places;
            m_Around = Array.ConvertAll(m_Places, _ => new List<int>());
            m_Quadrics = new Quadric[m_Places.Length];
            m_Locked = Doubles(m_Places);
            m_Best = new (double, int)[m_Places.Length];
            m_Met = new int[m_Places.Length];
            m_Shared = new int[m_Places.Length];
            m_PartCount = parts.Count;
            for (int part = 0; part < parts.Count; part++)
                AddPart(parts[part], part);
            m_Count = m_Triangles.Count;
            AddMargins();
            for (int vertex = 0; vertex < m_Places.Length; vertex++)
                Update(vertex);
        }

        /// <summary>Triangles that remain.</summary>
        public int Count => m_Count;

        /// <summary>Takes vertices out until so many triangles remain, or none can go.</summary>
        public void ReduceTo(int triangles)
        {
            while (m_Count > triangles && m_Queue.Count > 0)
            {
                (double _, int vertex) = m_Queue.Min;
                int to = m_Best[vertex].To;
                Examine(vertex);
                if (CanMove(vertex, to))
                    Move(vertex, to);
                else
                    Unlist(vertex);
            }
        }

        /// <summary>
        /// Drops pieces that hang together and whose extent is below a length, the smallest first, while more than so many triangles
        /// remain; those of vertices that stay are left.
        /// </summary>
        public void DropPieces(float extent, int triangles, bool[] stays = null)
        {
            var pieces = new List<(float Extent, List<int> Triangles)>();
            bool[] seen = new bool[m_Triangles.Count];
            for (int first = 0; first < seen.Length; first++)
            {
                if (!seen[first] && m_Alive[first] && !(stays?[m_Triangles[first].x] ?? false))
                    pieces.Add(Piece(first, seen));
            }

            pieces.Sort((a, b) => a.Extent.CompareTo(b.Extent));
            foreach ((float size, List<int> piece) in pieces)
            {
                if (size >= extent || m_Count <= triangles)
                    return;
                foreach (int triangle in piece)
                    Kill(triangle);
            }
        }

        /// <summary>[part] Corners of the triangles that remain.</summary>
        public int[][] Parts()
        {
            List<int>[] parts = Array.ConvertAll(new int[m_PartCount], _ => new List<int>());
            for (int triangle = 0; triangle < m_Triangles.Count; triangle++)
            {
                int3 corners = m_Triangles[triangle];
                if (m_Alive[triangle])
                    parts[m_Parts[triangle]].AddRange(new[] { corners.x, corners.y, corners.z });
            }

            return Array.ConvertAll(parts, part => part.ToArray());
        }

        // Vertices that share their place with another one, as along seams: moving one of them would open the surface.
        private static bool[] Doubles(float3[] points)
        {
            int[] places = VertexWeld.Exact(points);
            bool[] doubles = new bool[points.Length];
            for (int vertex = 0; vertex < points.Length; vertex++)
            {
                if (places[vertex] != vertex)
                    doubles[vertex] = doubles[places[vertex]] = true;
            }

            return doubles;
        }

        private void AddPart(int[] corners, int part)
        {
            for (int k = 0; k < corners.Length; k += 3)
            {
                var triangle = new int3(corners[k], corners[k + 1], corners[k + 2]);
                float3 normal = Area(triangle);
                float area = math.length(normal);
                if (!(area > 0f))
                    continue;
                normal /= area;
                float d = -math.dot(normal, m_Places[triangle.x]);
                for (int c = 0; c < 3; c++)
                {
                    m_Around[triangle[c]].Add(m_Triangles.Count);
                    m_Quadrics[triangle[c]].Add(normal.x, normal.y, normal.z, d, area);
                    m_Quadrics[triangle[c]].AddPoint(m_Places[triangle[c]], k_Way * area);
                }

                m_Triangles.Add(triangle);
                m_Parts.Add(part);
                m_Alive.Add(true);
            }
        }

        // Planes that stand on the edges of single triangles.
        private void AddMargins()
        {
            foreach (int3 triangle in m_Triangles)
            {
                float3 normal = math.normalizesafe(Area(triangle));
                for (int c = 0; c < 3; c++)
                {
                    int a = triangle[c], b = triangle[(c + 1) % 3];
                    if (Shared(a, b) != 1)
                        continue;
                    float3 along = m_Places[b] - m_Places[a], across = math.normalizesafe(math.cross(along, normal));
                    float d = -math.dot(across, m_Places[a]);
                    double weight = k_Margin * math.lengthsq(along);
                    m_Quadrics[a].Add(across.x, across.y, across.z, d, weight);
                    m_Quadrics[b].Add(across.x, across.y, across.z, d, weight);
                }
            }
        }

        private float3 Area(int3 triangle) =>
            math.cross(m_Places[triangle.y] - m_Places[triangle.x], m_Places[triangle.z] - m_Places[triangle.x]);

        // Triangles on an edge.
        private int Shared(int a, int b)
        {
            int count = 0;
            foreach (int triangle in m_Around[a])
                count += HasCorner(m_Triangles[triangle], b) ? 1 : 0;
            return count;
        }

        private static bool HasCorner(int3 triangle, int vertex) => triangle.x == vertex || triangle.y == vertex || triangle.z == vertex;

        private static int3 Moved(int3 triangle, int vertex, int to) => new int3(
            triangle.x == vertex ? to : triangle.x, triangle.y == vertex ? to : triangle.y, triangle.z == vertex ? to : triangle.z);

        private void FindNeighbours(int vertex, List<int> found)
        {
            found.Clear();
            m_Met[vertex] = ++m_Search;
            AddNeighbours(vertex, found);
        }

        // Those that the search has not met yet.
        private void AddNeighbours(int vertex, List<int> found)
        {
            foreach (int triangle in m_Around[vertex])
            {
                int3 corners = m_Triangles[triangle];
                Add(corners.x);
                Add(corners.y);
                Add(corners.z);
            }

            void Add(int neighbour)
            {
                if (m_Met[neighbour] == m_Search)
                    return;
                m_Met[neighbour] = m_Search;
                found.Add(neighbour);
            }
        }

        // What a vertex that is to move has around it.
        private void Examine(int vertex)
        {
            foreach (int neighbour in m_Neighbours)
                m_Shared[neighbour] = 0;
            FindNeighbours(vertex, m_Neighbours);
            m_Areas.Clear();
            foreach (int index in m_Around[vertex])
            {
                int3 triangle = m_Triangles[index];
                for (int c = 0; c < 3; c++)
                    m_Shared[triangle[c]]++;
                m_Areas.Add(Area(triangle));
            }

            m_OnMargin = false;
            foreach (int neighbour in m_Neighbours)
                m_OnMargin |= m_Shared[neighbour] == 1;
            m_Shared[vertex] = 0;
        }

        private void Unlist(int vertex) => m_Queue.Remove((m_Best[vertex].Cost, vertex));

        private void Update(int vertex)
        {
            Unlist(vertex);
            if (m_Locked[vertex] || m_Around[vertex].Count == 0)
                return;
            (double Cost, int To) best = (Cost: double.PositiveInfinity, To: -1);
            Examine(vertex);
            foreach (int to in m_Neighbours)
            {
                double cost = m_Quadrics[vertex].At(m_Places[to]);
                if (cost < best.Cost && CanMove(vertex, to))
                    best = (cost, to);
            }

            m_Best[vertex] = best;
            if (best.To >= 0)
                m_Queue.Add((best.Cost, vertex));
        }

        // The vertex has been examined.
        private bool CanMove(int vertex, int to)
        {
            int shared = m_Shared[to];
            if (shared == 0 || shared > 2 || (m_OnMargin && shared != 1))
                return false;
            FindNeighbours(to, m_Others);
            int common = 0;
            foreach (int neighbour in m_Neighbours)
                common += neighbour != to && m_Met[neighbour] == m_Search ? 1 : 0;
            if (common != shared)
                return false;
            List<int> around = m_Around[vertex];
            for (int k = 0; k < around.Count; k++)
            {
                int3 triangle = m_Triangles[around[k]];
                if (HasCorner(triangle, to))
                    continue;
                float3 before = m_Areas[k], after = Area(Moved(triangle, vertex, to));
                if (math.dot(before, after) <= k_Flip * math.length(before) * math.length(after))
                    return false;
            }

            return true;
        }

        private void Move(int vertex, int to)
        {
            FindNeighbours(vertex, m_Touched);
            Unlist(vertex);
            foreach (int index in m_Around[vertex].ToArray())
            {
                int3 triangle = m_Triangles[index];
                if (HasCorner(triangle, to))
                {
                    Kill(index);
                    continue;
                }

                m_Triangles[index] = Moved(triangle, vertex, to);
                m_Around[to].Add(index);
            }

            m_Around[vertex].Clear();
            m_Quadrics[to].Add(m_Quadrics[vertex]);
            m_Search++;
            foreach (int neighbour in m_Touched)
                m_Met[neighbour] = m_Search;
            AddNeighbours(to, m_Touched);
            foreach (int neighbour in m_Touched)
                Update(neighbour);
        }

        private void Kill(int triangle)
        {
            m_Alive[triangle] = false;
            m_Count--;
            for (int c = 0; c < 3; c++)
                m_Around[m_Triangles[triangle][c]].Remove(triangle);
        }

        private (float Extent, List<int> Triangles) Piece(int first, bool[] seen)
        {
            var piece = new List<int>();
            var open = new Stack<int>();
            open.Push(first);
            seen[first] = true;
            float3 min = float.PositiveInfinity, max = float.NegativeInfinity;
            while (open.Count > 0)
            {
                int triangle = open.Pop();
                piece.Add(triangle);
                for (int c = 0; c < 3; c++)
                {
                    int vertex = m_Triangles[triangle][c];
                    min = math.min(min, m_Places[vertex]);
                    max = math.max(max, m_Places[vertex]);
                    foreach (int other in m_Around[vertex])
                    {
                        if (seen[other])
                            continue;
                        seen[other] = true;
                        open.Push(other);
                    }
                }
            }

            return (math.distance(min, max), piece);
        }
    }
}
