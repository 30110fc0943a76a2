using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>An insect while it lives: its meshes and wings, how its body moves, and with how much detail it is computed.</summary>
    internal sealed class LiveInsect
    {
        /// <summary>
        /// Beats after which amplitudes set to zero have died away: up to one until they are latched, then three and a half that the waves
        /// reach back.
        /// </summary>
        private const float k_BeatsToRest = 5f;

        public readonly InsectWings insect;
        public readonly Transform root;
        public readonly List<LiveMesh> meshes = new List<LiveMesh>();

        /// <summary>Wings, in the order of the insect's list.</summary>
        public LiveWing[] wings = System.Array.Empty<LiveWing>();

        /// <summary>Number of the insect's own clock.</summary>
        public readonly int owner;

        public BodyFlight flight;
        public MotionSampler motion;
        public bool visible = true;

        /// <summary>Number of completed beats at the last check.</summary>
        public int beats;

        private PackKey m_PackKey;
        private GuardedVector m_Wind, m_Velocity, m_Turning;
        private bool m_Resting, m_Seen, m_Skinned = true, m_Smaller;
        private double m_RestingSince, m_AsleepSince;

        public LiveInsect(InsectWings insect, int owner)
        {
            this.insect = insect;
            this.owner = owner;
            root = insect.transform;
        }

        /// <summary>The level of detail now.</summary>
        public WingDetail Detail => m_PackKey.detail;

        /// <summary>True where its meshes are deformed.</summary>
        public bool IsSkinned => m_Skinned;

        /// <summary>Pitch of the body, radians, nose up positive.</summary>
        public float Pitch => flight.Pitch;

        /// <summary>Clock of the wings.</summary>
        public WingUpdateMode Clock => insect.UpdateMode;

        /// <summary>Factor on the amplitudes: 0 while the wings come to rest.</summary>
        private float Fade => m_Resting ? 0f : 1f;

        // Largest speed, world units per second.
        private float MostSpeed
        {
            get
            {
                float metres = insect.MotionSettings.metresPerUnit;
                if (metres > 0f)
                    return OuterBounds.Speed / metres;
                LiveWing wing = wings[0];
                bool hasSize = wing.placed.isValid && wing.values != null;
                return hasSize ? OuterBounds.Speed * wing.placed.length / wing.values.size.wingLength : OuterBounds.Speed;
            }
        }

        /// <summary>
        /// Reason why the processor deforms a mesh though the graphics card is wanted, a part of a sentence; null where there is none.
        /// </summary>
        public string Obstacle
        {
            get
            {
                foreach (LiveMesh mesh in meshes)
                {
                    if (mesh.Obstacle != null)
                        return mesh.Obstacle;
                }

                return null;
            }
        }

        /// <summary>Number of vertices that took as long to copy as its meshes took to make.</summary>
        public int VerticesBuilt => meshes.Sum(mesh => mesh.VerticesBuilt);

        /// <summary>Adds the wings to the world that are not in it yet.</summary>
        /// <param name="world">Where all wings are.</param>
        /// <param name="presets">The presets in use.</param>
        /// <param name="leader">A wing of the insect whose beat goes on; none starts a new one.</param>
        public void Enter(WingWorld world, AssetWatch<WingPreset, PresetValues> presets, WingHandle leader = default)
        {
            if (leader.IsNone)
            {
                m_PackKey = new PackKey(Clock, owner, WingDetail.Full);
                UpdateSurroundings(Physics.gravity, null);
            }

            foreach (LiveWing wing in wings)
            {
                if (!wing.handle.IsNone)
                    continue;
                wing.ApplyParameters(presets, new InsectTuning(insect, Fade), out WingParameters parameters);
                wing.Place();
                WingSurroundings around = wing.Surroundings(flight, Pitch);
                wing.handle = world.Add(wing.rig, parameters, around.IsFinite ? around : default, m_PackKey, wing.packing, wing.moves);
                if (wing.joint >= 0)
                    world.PlaceJoints(wing.handle, wing.joint);
                world.SetSkinned(wing.handle, m_Skinned);
                world.SetSmaller(wing.handle, m_Smaller);
                if (!leader.IsNone)
                    world.Follow(wing.handle, leader);
            }

            foreach (LiveMesh mesh in meshes)
                mesh.ShowSmaller(m_Smaller);
            if (leader.IsNone)
                Start(world);
        }

        /// <summary>Restarts all wings, at the insect's phase.</summary>
        public void Restart(WingWorld world)
        {
            foreach (LiveWing wing in wings)
                world.Reset(wing.handle);
            Start(world);
        }

        /// <summary>Takes over values of sliders and presets.</summary>
        public void ApplyParameters(WingWorld world, AssetWatch<WingPreset, PresetValues> presets)
        {
            var tuning = new InsectTuning(insect, Fade);
            foreach (LiveWing wing in wings)
            {
                if (wing.ApplyParameters(presets, tuning, out WingParameters parameters))
                    world.SetParameters(wing.handle, parameters);
                wing.Fold(world, tuning.Fold, insect.Flyer != null);
            }
        }

        /// <summary>Samples how the body moved in the frame.</summary>
        /// <returns>Whether it jumped.</returns>
        public bool SampleMotion(float dt)
        {
            InsectMotion settings = insect.MotionSettings;
            float length = wings[0].placed.isValid ? wings[0].placed.length : 1f;
            bool heeded = settings.onTeleport != TeleportResponse.Ignore;
            float distance = heeded ? settings.teleportDistance * length : MostSpeed * dt;
            float angle = heeded && settings.teleportAngle < 180f ? settings.teleportAngle : float.PositiveInfinity;
            root.GetPositionAndRotation(out Vector3 position, out Quaternion rotation);
            return motion.Sample(position, rotation, dt, length, distance, angle);
        }

        /// <summary>Records motion, wind and gravity of the body.</summary>
        /// <param name="gravity">World units per second squared.</param>
        /// <param name="zones">The wind zones; null where none blows.</param>
        public void UpdateSurroundings(float3 gravity, WindZones zones)
        {
            InsectMotion settings = insect.MotionSettings;
            root.GetPositionAndRotation(out Vector3 position, out Quaternion rotation);
            flight.position = position;
            flight.forward = rotation * Vector3.forward;
            flight.gravity = gravity;
            flight.metresPerUnit = settings.metresPerUnit;
            float3 wind = insect.Air.wind;
            if (insect.Air.windZones && zones != null)
                wind += zones.At(position);
            float mostSpeed = MostSpeed;
            flight.wind = m_Wind.Guard(wind, mostSpeed, "a wind", "world units/s", insect);
            float3 velocity = motion.Velocity, turning = motion.AngularVelocity;
            if (settings.source == VelocitySource.Script)
            {
                velocity = insect.Velocity;
                turning = insect.AngularVelocity;
            }
            else if (settings.source == VelocitySource.Rigidbody && insect.Body is { } body && body != null)
            {
                velocity = body.GetPointVelocity(flight.position);
                turning = body.angularVelocity;
            }

            flight.velocity = m_Velocity.Guard(velocity, mostSpeed, "a velocity", "world units/s", insect);
            flight.angularVelocity = m_Turning.Guard(turning, OuterBounds.Turning, "an angular velocity", "rad/s", insect);
        }

        /// <summary>Writes the surroundings of the wings.</summary>
        /// <returns>False when a wing has no size.</returns>
        public bool WriteSurroundings(WingWorld world)
        {
            bool valid = true, flies = insect.Flyer != null;
            float pitch = flies ? 0f : Pitch;
            foreach (LiveWing wing in wings)
            {
                wing.Place();
                valid &= wing.placed.isValid;
                if (wing.placed.isValid && !flies)
                    world.TrySetSurroundings(wing.handle, wing.Surroundings(flight, pitch));
            }

            return valid;
        }

        /// <summary>Chooses the level of detail by the insect's size in the cameras, and whether its meshes are deformed.</summary>
        /// <returns>Whether its meshes have to be drawn again though nothing may have moved.</returns>
        public bool ChooseDetail(WingWorld world, Viewers viewers, Clocks clocks)
        {
            // No camera has had a look at a new one.
            visible = !m_Seen;
            m_Seen = true;
            foreach (LiveMesh mesh in meshes)
                visible |= mesh.renderer != null && mesh.renderer.isVisible;
            bool outOfSight = !visible && insect.Quality.culling == WingCulling.CullCompletely && !insect.Quality.keepForces;
            if (Clock == WingUpdateMode.Manual)
                Pace(world, WingDetail.Full, false, clocks);
            else
                Pace(world, Wanted(viewers), outOfSight, clocks);
            bool whole = SetSmaller(world);
            return SetSkinned(world) || (whole && m_Skinned);
        }

        /// <summary>Uploads what a picture shows: the deformed vertices, or that they have not moved since the last one.</summary>
        /// <param name="world">Where the wings are.</param>
        /// <param name="drawn">Whether the wings' clock was drawn.</param>
        public void Upload(WingWorld world, bool drawn)
        {
            foreach (LiveMesh mesh in meshes)
            {
                if (drawn && m_Skinned)
                    mesh.Upload(world);
                else
                    mesh.Stop(world);
            }
        }

        /// <summary>Level of detail by size and budget. Who is only far from the nearest does not come to rest.</summary>
        /// <param name="levels">Sizes below which each level begins.</param>
        /// <param name="height">Share of the screen's height.</param>
        /// <param name="now">The present level.</param>
        /// <param name="budget">Time that all wings may take.</param>
        public static WingDetail Choose(in ScreenHeights levels, float height, WingDetail now, DetailBudget budget)
        {
            WingDetail own = levels.Choose(height, now);
            float counted = budget.Counted(height);
            if (!budget.IsTight || own >= WingDetail.WavesOnly)
                return own;
            WingDetail cheaper = levels.Choose(counted, now);
            return cheaper < WingDetail.WavesOnly ? cheaper : WingDetail.WavesOnly;
        }

        private WingDetail Wanted(Viewers viewers)
        {
            // Where nothing is computed nobody else looks where the wings are.
            if (Detail == WingDetail.Frozen)
                wings[0].Place();
            if (!insect.Quality.levelOfDetail || !viewers.Any || !wings[0].placed.isValid)
                return WingDetail.Full;
            float height = viewers.ScreenHeight(wings[0].placed.hinge, wings[0].placed.length);
            WingDetail now = m_Resting ? WingDetail.Frozen : Detail;
            WingDetail wanted = Choose(insect.Quality.screenHeights, height, now, viewers.Budget);
            return insect.Quality.keepForces && wanted > WingDetail.CoarsePatches ? WingDetail.CoarsePatches : wanted;
        }

        /// <summary>Changes clock and level of detail without a jump.</summary>
        public void Pace(WingWorld world, WingDetail wanted, bool outOfSight, Clocks clocks)
        {
            WingUpdateMode clock = Clock;
            double now = clocks.times[clock].time, shift = now - clocks.times[m_PackKey.clock].time;
            m_RestingSince += shift;
            m_AsleepSince += shift;
            bool resting = wanted == WingDetail.Frozen && !outOfSight;
            if (resting && !m_Resting)
                m_RestingSince = now;
            m_Resting = resting;
            if (resting && m_PackKey.detail != WingDetail.Frozen)
            {
                // Amplitudes die away first; then standing still cannot be told from beating.
                float frequency = world.Read(wings[0].handle).Frequency;
                wanted = (now - m_RestingSince) * frequency > k_BeatsToRest ? WingDetail.Frozen : WingDetail.WavesOnly;
            }

            var packKey = new PackKey(clock, owner, outOfSight ? WingDetail.Frozen : wanted);
            if (packKey.Equals(m_PackKey))
                return;
            bool wakes = m_PackKey.detail == WingDetail.Frozen && packKey.detail != WingDetail.Frozen;
            bool sleeps = m_PackKey.detail != WingDetail.Frozen && packKey.detail == WingDetail.Frozen;
            float slept = (float)math.max(now - m_AsleepSince, 0.0);
            foreach (LiveWing wing in wings)
            {
                world.SetPackKey(wing.handle, packKey);
                if (wakes)
                    world.Resume(wing.handle, slept);
            }

            m_PackKey = packKey;
            if (sleeps)
                m_AsleepSince = now;
        }

        // Returns whether vertices are shown that were not deformed before. Who is out of sight or at rest keeps its mesh.
        private bool SetSmaller(WingWorld world)
        {
            bool smaller = Detail >= WingDetail.CoarsePatches;
            if (smaller == m_Smaller || Detail == WingDetail.Frozen)
                return false;
            m_Smaller = smaller;
            foreach (LiveWing wing in wings)
                world.SetSmaller(wing.handle, smaller);
            foreach (LiveMesh mesh in meshes)
                mesh.ShowSmaller(smaller);
            return !smaller;
        }

        private bool SetSkinned(WingWorld world)
        {
            bool skinned = m_PackKey.detail != WingDetail.Frozen && (visible || insect.Quality.culling == WingCulling.AlwaysSimulate);
            if (skinned != m_Skinned)
            {
                foreach (LiveWing wing in wings)
                    world.SetSkinned(wing.handle, skinned);
            }

            bool again = skinned && !m_Skinned;
            m_Skinned = skinned;
            return again;
        }

        private void Start(WingWorld world)
        {
            foreach (LiveWing wing in wings)
            {
                float frequency = world.Read(wing.handle).Frequency;
                world.Resume(wing.handle, insect.StartPhase / (360f * frequency));
            }

            beats = world.Read(wings[0].handle).Beats;
        }
    }
}
