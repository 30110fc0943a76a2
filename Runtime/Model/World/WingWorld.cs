using System;
using System.Collections.Generic;
using Unity.Jobs;
using Unity.Mathematics;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// A set of wings that are stepped and skinned together, in two jobs a frame whatever their number. Owns all live native memory.
    /// Not thread-safe: call from one thread. Nothing is allocated by stepping and skinning.
    /// </summary>
    /// <example><code>
    /// using var world = new WingWorld();
    /// WingHandle wing = world.Add(rig, preset.ToParameters());
    /// world.Step(1f / 50f);
    /// world.Skin();
    /// NativeArray&lt;SkinnedVertex&gt; deformed = world.Vertices(wing);
    /// </code></example>
    [MovedFrom(true, null, "Alate")]
    public sealed partial class WingWorld : IDisposable
    {
        private readonly List<WingEntry> m_Entries = new List<WingEntry>();
        private readonly Stack<int> m_Free = new Stack<int>();
        private readonly PackTable m_Packs = new PackTable();
        private readonly BodyTable m_Bodies = new BodyTable();
        private readonly JobArrays m_Arrays;
        private JobHandle m_Pending;
        private int m_NextVersion = 1;
        private bool m_Disposed;

        /// <summary>Creates an empty world.</summary>
        public WingWorld() => m_Arrays = new JobArrays(m_Bodies);

        /// <summary>Number of wings in the world.</summary>
        public int Count { get; private set; }

        /// <summary>Number of jobs scheduled so far: one a step and one a skin, for one wing as for a thousand.</summary>
        public long JobCount => m_Arrays.JobCount;

        /// <summary>Number of packs of four wings in use.</summary>
        public int PackCount => m_Packs.Packs.Count;

        /// <summary>Adds a wing in its driven pose at the start of its beat.</summary>
        /// <exception cref="ArgumentNullException">No rig.</exception>
        /// <exception cref="ArgumentException">The rig is disposed, or a parameter is out of its range; names it, its value and the
        /// range.</exception>
        public WingHandle Add(WingRig rig, in WingParameters parameters) => Add(rig, parameters, default);

        /// <summary>Adds a wing that starts in the given surroundings.</summary>
        /// <inheritdoc cref="Add(WingRig, in WingParameters)"/>
        public WingHandle Add(WingRig rig, in WingParameters parameters, in WingSurroundings surroundings) =>
            Add(rig, parameters, surroundings, default);

        internal WingHandle Add(
            WingRig rig, in WingParameters parameters, in WingSurroundings surroundings, in PackKey packKey,
            VertexPacking packing = VertexPacking.None, bool moves = false)
        {
            if (rig == null)
                throw new ArgumentNullException(nameof(rig));
            if (rig.IsDisposed)
                throw new ArgumentException("The rig has been disposed.", nameof(rig));
            Check(parameters);
            Check(surroundings);
            CompleteUse();

            int index = m_Free.Count > 0 ? m_Free.Pop() : m_Entries.Count;
            if (index == m_Entries.Count)
                m_Entries.Add(null);
            var entry = new WingEntry(rig, m_NextVersion++, parameters, packing, moves) { surroundings = surroundings, packKey = packKey };
            m_Entries[index] = entry;
            Count++;
            m_Arrays.Download(m_Packs.Packs, m_Entries);
            m_Packs.Add(entry, index);
            DeriveAndRestart(entry, restart: true);
            return new WingHandle(index, entry.version);
        }

        /// <summary>Removes a wing and frees its vertices.</summary>
        /// <exception cref="ArgumentException">No such wing.</exception>
        public void Remove(WingHandle wing)
        {
            WingEntry entry = Entry(wing);
            m_Arrays.Download(m_Packs.Packs, m_Entries);
            m_Bodies.Detach(entry);
            Detach(entry);
            m_Entries[wing.index] = null;
            m_Free.Push(wing.index);
            Count--;
            entry.Dispose();
        }

        /// <summary>True while the wing is in this world.</summary>
        public bool Contains(WingHandle wing) =>
            !m_Disposed && !wing.IsNone && wing.index < m_Entries.Count && m_Entries[wing.index]?.version == wing.version;

        /// <summary>
        /// Changes a wing's parameters; they are seen from the next substep on, frequency and amplitude from the next beat on.
        /// </summary>
        /// <exception cref="ArgumentException">No such wing, or a parameter is out of its range.</exception>
        public void SetParameters(WingHandle wing, in WingParameters parameters)
        {
            Check(parameters);
            WingEntry entry = Entry(wing);
            bool regroup = !entry.parameters.options.Equals(parameters.options);
            entry.parameters = parameters;
            if (regroup)
                Regroup(entry, wing.index);
            Write(entry);
        }

        /// <summary>Sets the level of detail of a wing from the next step on; its motion goes on without a jump.</summary>
        /// <exception cref="ArgumentException">No such wing.</exception>
        public void SetDetail(WingHandle wing, WingDetail detail)
        {
            PackKey packKey = Entry(wing).packKey;
            SetPackKey(wing, new PackKey(packKey.clock, packKey.owner, detail));
        }

        internal void SetPackKey(WingHandle wing, in PackKey packKey)
        {
            WingEntry entry = Entry(wing);
            if (entry.packKey.Equals(packKey))
                return;
            entry.packKey = packKey;
            Regroup(entry, wing.index);
            Write(entry);
        }

        /// <summary>Sets the surroundings of a wing, effective from the next substep on.</summary>
        /// <exception cref="ArgumentException">No such wing, or a value that is not finite.</exception>
        public void SetSurroundings(WingHandle wing, in WingSurroundings surroundings)
        {
            Check(surroundings);
            Entry(wing).Meet(surroundings);
        }

        /// <summary>Sets the surroundings of a wing where all of them are finite; otherwise the former ones count.</summary>
        internal void TrySetSurroundings(WingHandle wing, in WingSurroundings surroundings)
        {
            if (surroundings.IsFinite)
                Entry(wing).Meet(surroundings);
        }

        /// <summary>Puts a wing back to the start of its beat, in the driven pose, at rest.</summary>
        /// <exception cref="ArgumentException">No such wing.</exception>
        public void Reset(WingHandle wing)
        {
            WingEntry entry = Entry(wing);
            DeriveAndRestart(entry, restart: true);
            m_Arrays.SetDisplaces(entry, false);
        }

        /// <summary>
        /// Advances a wing's beat by a time in which it was not stepped, seconds: in phase with the stepped wings, in the driven pose,
        /// without a kick.
        /// </summary>
        /// <exception cref="ArgumentException">No such wing, or a time that is negative, above 10⁹ or not finite.</exception>
        public void Resume(WingHandle wing, float seconds)
        {
            if (!(seconds >= 0f && seconds <= OuterBounds.Seconds))
            {
                throw new ArgumentException(
                    $"The time to make up for must be 0 to {OuterBounds.Seconds} seconds, not {seconds}.", nameof(seconds));
            }
            WingEntry entry = Entry(wing);
            m_Arrays.Resume(entry.pack, entry.lane, seconds);
        }

        /// <summary>Moves a wing to the phase of another one, in its own driven pose, without a kick.</summary>
        internal void Follow(WingHandle wing, WingHandle leader)
        {
            WingEntry follower = Entry(wing), led = Entry(leader);
            m_Arrays.Follow(follower.pack, follower.lane, led.pack, led.lane);
        }

        /// <summary>Chooses whether <see cref="Skin"/> deforms a wing; otherwise its vertices stay as they are.</summary>
        /// <exception cref="ArgumentException">No such wing.</exception>
        public void SetSkinned(WingHandle wing, bool skinned) => m_Arrays.SetSkinned(Entry(wing), skinned);

        /// <summary>
        /// Chooses whether <see cref="Skin"/> deforms the vertices of the smaller mesh alone; the others stay as they are. Its bounds are
        /// those of the vertices that were deformed.
        /// </summary>
        internal void SetSmaller(WingHandle wing, bool smaller) => m_Arrays.SetSmaller(Entry(wing), smaller);

        /// <summary>Advances all wings by one fixed step, seconds; does nothing where dt is not positive. Returns when done.</summary>
        /// <exception cref="ArgumentException">dt is not finite.</exception>
        public void Step(float dt)
        {
            ScheduleStep(dt);
            Complete();
        }

        /// <summary>Schedules a step behind what is pending and <paramref name="after"/>; does nothing where dt is not positive.</summary>
        /// <exception cref="ArgumentException">dt is not finite.</exception>
        public JobHandle ScheduleStep(float dt, JobHandle after = default)
        {
            CheckNotDisposed();
            if (!math.isfinite(dt))
                throw new ArgumentException($"The time step must be finite, not {dt}.", nameof(dt));
            return ScheduleStep(ClockTimes.All(new ClockTime { length = dt, count = 1, inUse = true }), after);
        }

        /// <summary>Schedules the steps that are due on each clock, in one job.</summary>
        internal JobHandle ScheduleStep(ClockTimes clocks, JobHandle after = default)
        {
            m_Pending = Behind(after);
            if (!clocks.AnyDue() || Count == 0)
                return m_Pending;
            Upload();
            m_Pending = m_Arrays.ScheduleStep(clocks, m_Pending);
            return m_Pending;
        }

        /// <summary>Steps the wings of one owner on the calling thread.</summary>
        internal void StepNow(int owner, float dt)
        {
            CompleteUse();
            Upload();
            m_Arrays.StepNow(m_Packs.Packs, owner, dt);
        }

        /// <summary>Deforms all meshes at a time within the last step: 0 its start, 1 its end. Returns when done.</summary>
        public void Skin(float alpha = 1f)
        {
            ScheduleSkin(alpha);
            Complete();
        }

        /// <summary>Schedules the skinning behind what is pending and <paramref name="after"/>.</summary>
        public JobHandle ScheduleSkin(float alpha, JobHandle after = default) =>
            ScheduleSkin(ClockTimes.All(new ClockTime { alpha = math.isfinite(alpha) ? alpha : 1f, moved = true, inUse = true }), after);

        /// <summary>Schedules the skinning of the wings of the clocks that moved.</summary>
        internal JobHandle ScheduleSkin(in ClockTimes clocks, JobHandle after = default)
        {
            CheckNotDisposed();
            m_Pending = Behind(after);
            if (Count == 0)
                return m_Pending;
            Upload();
            m_Pending = m_Arrays.ScheduleSkin(clocks, JointTexels, m_Pending);
            return m_Pending;
        }

        /// <summary>Waits for all scheduled work.</summary>
        public void Complete()
        {
            m_Pending.Complete();
            m_Pending = default;
        }

        /// <summary>Waits for pending work and frees everything; the rigs are released.</summary>
        public void Dispose()
        {
            if (m_Disposed)
                return;
            Complete();
            m_Disposed = true;
            foreach (WingEntry entry in m_Entries)
                entry?.Dispose();
            m_Packs.Dispose();
            m_Bodies.Dispose();
            m_Arrays.Dispose();
        }

        private JobHandle Behind(JobHandle after) => after == default ? m_Pending : JobHandle.CombineDependencies(m_Pending, after);

        private void Upload() => m_Arrays.Upload(m_Packs.Packs, m_Entries);

        // Moves a wing to a pack of its new kind, state and all.
        private void Regroup(WingEntry entry, int index)
        {
            m_Arrays.Download(m_Packs.Packs, m_Entries);
            PackMemory from = entry.pack.Snapshot(entry.lane);
            Detach(entry);
            m_Packs.Add(entry, index).CopyWing(from, 0, entry.lane);
            from.Dispose();
        }

        private void Detach(WingEntry entry)
        {
            int moved = m_Packs.Remove(entry);
            if (moved < 0)
                return;
            m_Entries[moved].pack = entry.pack;
            m_Entries[moved].lane = entry.lane;
        }

        private unsafe void Write(WingEntry entry)
        {
            for (int lane = 0; lane < WingPack.Lanes; lane++)
            {
                if (entry.pack.Writes(entry.lane, lane))
                    entry.pack.view.Set(lane, entry.parameters);
            }
            DeriveAndRestart(entry, restart: false);
        }

        private void DeriveAndRestart(WingEntry entry, bool restart) => m_Arrays.Refresh(entry.pack, entry.lane, restart);

        private WingEntry Entry(WingHandle wing)
        {
            CompleteUse();
            if (!Contains(wing))
                throw new ArgumentException($"This world has no such wing: {wing}.", nameof(wing));
            return m_Entries[wing.index];
        }

        private void CompleteUse()
        {
            CheckNotDisposed();
            Complete();
        }

        private void CheckNotDisposed()
        {
            if (m_Disposed)
                throw new ObjectDisposedException(nameof(WingWorld));
        }

        private static void Check(in WingParameters parameters)
        {
            string problem = parameters.FindProblem();
            if (problem != null)
                throw new ArgumentException(problem, nameof(parameters));
        }

        private static void Check(in WingSurroundings surroundings)
        {
            string problem = surroundings.FindProblem();
            if (problem != null)
                throw new ArgumentException(problem, nameof(surroundings));
        }
    }
}
