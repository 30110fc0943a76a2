using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Free wake of a wing: rows of points that were shed at its trailing edge, the newest first, with a row of rings between each two.
    /// </summary>
    internal sealed class VortexSheet
    {
        /// <summary>
        /// Fastest that vortices drive a point, reference lengths a beat: ten times and more what the tip of an insect's wing does. Keeps
        /// wings that cross their own wakes from throwing points beyond what floats resolve.
        /// </summary>
        private const float k_Fastest = 100f;

        private readonly WakeCores m_Cores;
        private readonly int m_Width, m_Capacity;

        // Rings of rows; row k of the sheet is at (m_Head + k) % capacity.
        private readonly float3[] m_Points, m_Velocities;
        private readonly float[] m_Circulation, m_Ages;
        private readonly bool[] m_Moved;
        private int m_Head;

        /// <summary>An empty sheet.</summary>
        /// <param name="panels">Panels of the wing along its span.</param>
        /// <param name="rows">Rows that it keeps.</param>
        /// <param name="cores">Cores of its vortices.</param>
        public VortexSheet(int panels, int rows, in WakeCores cores)
        {
            m_Cores = cores;
            m_Width = panels + 1;
            m_Capacity = rows;
            m_Points = new float3[rows * m_Width];
            m_Velocities = new float3[rows * m_Width];
            m_Circulation = new float[rows * m_Width];
            m_Ages = new float[rows];
            m_Moved = new bool[rows];
        }

        /// <summary>Number of rows of points.</summary>
        public int RowCount { get; private set; }

        /// <summary>Number of points of a row.</summary>
        public int Width => m_Width;

        public int PointCount => RowCount * m_Width;

        /// <summary>Most vertices that the sheet writes.</summary>
        public int MostVertices => 2 * m_Capacity * m_Width;

        public float3 Point(int row, int j) => m_Points[Index(row, j)];

        /// <summary>Circulation of the ring between a row and the next one.</summary>
        public float Circulation(int row, int j) => m_Circulation[Index(row, j)];

        public float Age(int row) => m_Ages[(m_Head + row) % m_Capacity];

        /// <summary>Sheds a row at the wing's edge; the ring behind it gets the circulation that the edge had a step before.</summary>
        public void Shed(WingLattice wing)
        {
            m_Head = (m_Head + m_Capacity - 1) % m_Capacity;
            RowCount = math.min(RowCount + 1, m_Capacity);
            m_Ages[m_Head] = 0f;
            m_Moved[m_Head] = false;
            for (int j = 0; j < m_Width; j++)
            {
                m_Points[Index(0, j)] = wing.Rings[wing.Corner(wing.ChordPanels, j)];
                m_Circulation[Index(0, j)] = RowCount > 1 && j < m_Width - 1 ? wing.Before[wing.Ring(wing.ChordPanels - 1, j)] : 0f;
            }
        }

        /// <summary>Writes the segments, each once with the circulation of the two rings beside it.</summary>
        public void Write(VortexField field)
        {
            for (int row = 0; row < RowCount; row++)
            {
                field.Begin(Point(row, 0));
                for (int j = 1; j < m_Width; j++)
                {
                    float behind = Ring(row, j - 1), ahead = Ring(row - 1, j - 1);
                    field.Add(Point(row, j), behind - ahead, m_Cores.Of(Age(row), math.max(math.abs(behind), math.abs(ahead))));
                }
            }

            for (int j = 0; j < m_Width; j++)
            {
                field.Begin(Point(0, j));
                for (int row = 1; row < RowCount; row++)
                {
                    float right = Ring(row - 1, j), left = Ring(row - 1, j - 1);
                    float age = 0.5f * (Age(row - 1) + Age(row));
                    field.Add(Point(row, j), left - right, m_Cores.Of(age, math.max(math.abs(left), math.abs(right))));
                }
            }
        }

        /// <summary>Writes the points at which the sheet's velocity is wanted.</summary>
        public void WritePoints(VortexField field, int first)
        {
            for (int k = 0; k < PointCount; k++)
                field.SetPoint(first + k, Point(k / m_Width, k % m_Width));
        }

        /// <summary>Moves the sheet by a step with the air: Adams and Bashforth's second-order scheme, Euler's for the new row.</summary>
        public void Move(VortexField field, int first, float3 stream, float step)
        {
            for (int row = 0; row < RowCount; row++)
            {
                int place = (m_Head + row) % m_Capacity;
                for (int j = 0; j < m_Width; j++)
                {
                    int at = Index(row, j);
                    float3 induced = field.Velocity(first + row * m_Width + j);
                    float speed = math.length(induced);
                    float3 velocity = stream + (speed <= k_Fastest ? induced : k_Fastest * math.normalizesafe(induced));
                    m_Points[at] += step * (m_Moved[place] ? 1.5f * velocity - 0.5f * m_Velocities[at] : velocity);
                    m_Velocities[at] = velocity;
                }

                m_Moved[place] = true;
                m_Ages[place] += step;
            }
        }

        // No ring before the newest row, behind the last, or beside the sheet.
        private float Ring(int row, int j) =>
            row < 0 || row >= RowCount - 1 || j < 0 || j >= m_Width - 1 ? 0f : m_Circulation[Index(row, j)];

        private int Index(int row, int j) => (m_Head + row) % m_Capacity * m_Width + j;
    }
}
