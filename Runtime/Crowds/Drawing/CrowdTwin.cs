using Alate.Flight;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Alate.Crowds
{
    /// <summary>One live insect that stands for a baked one.</summary>
    internal sealed class CrowdTwin
    {
        /// <summary>Substeps of a beat that bring live wings within 0.5 % of their length to baked ones, which are flown with 96.</summary>
        private const int k_Substeps = 64;

        private readonly Renderer[] m_Renderers;
        private readonly LoopFlyer m_Flyer = new LoopFlyer();
        private readonly float[] m_Amplitudes;
        private float m_Beats;

        /// <param name="prefab">What it is a copy of.</param>
        /// <param name="home">Scene of the crowd, with which the copy goes.</param>
        public CrowdTwin(InsectWings prefab, Scene home)
        {
            Wings = Object.Instantiate(prefab);
            if (Wings.gameObject.scene != home)
                SceneManager.MoveGameObjectToScene(Wings.gameObject, home);
            m_Renderers = Wings.GetComponentsInChildren<Renderer>(true);
            Wings.UpdateMode = WingUpdateMode.Update;
            Wings.Motion.source = VelocitySource.Script;
            Wings.Motion.onTeleport = TeleportResponse.Ignore;
            Wings.Quality.culling = WingCulling.AlwaysSimulate;
            Wings.Quality.levelOfDetail = false;
            Wings.Quality.substepsPerBeat = k_Substeps;
            Wings.gameObject.SetActive(true);
            if (Wings.TryGetComponent(out InsectFlight flight))
                flight.enabled = false;
            Wings.Flyer = m_Flyer;
            m_Amplitudes = Wings.Wings.ConvertAll(wing => wing.AmplitudeScale).ToArray();
            Leave();
        }

        /// <summary>The live insect.</summary>
        public InsectWings Wings { get; }

        /// <summary>Index of the crowd's insect that the twin stands for; −1 for none.</summary>
        public int Insect { get; private set; }

        /// <summary>True where it is seen instead of the baked one.</summary>
        public bool IsShown { get; private set; }

        /// <summary>Starts to stand for an insect of the crowd, unseen as yet.</summary>
        public void Replace(int insect, in CrowdPose pose)
        {
            Insect = insect;
            m_Beats = 0f;
            Wings.StartPhase = 360f * pose.phase;
            Wings.ResetState();
        }

        /// <summary>Leaves the insect that the twin stands for.</summary>
        public void Leave()
        {
            Insect = -1;
            Show(false);
        }

        /// <summary>Goes where the insect is, and keeps the baked one to the beat of the live wings.</summary>
        /// <param name="baked">The loops.</param>
        /// <param name="poses">The crowd, before its phases are advanced.</param>
        /// <param name="seconds">Time of the frame.</param>
        /// <param name="beatsToSettle">Beats before it is shown.</param>
        public void Follow(BakedInsect baked, NativeArray<CrowdPose> poses, float seconds, float beatsToSettle)
        {
            CrowdPose pose = poses[Insect];
            if (!CanShow(pose))
            {
                Leave();
                return;
            }

            CrowdLoop loop = baked.LoopAt(pose.blend < 0.5f ? pose.loop : pose.nextLoop);
            Transform body = Wings.transform;
            body.SetPositionAndRotation(pose.position, pose.rotation);
            body.localScale = Vector3.one * pose.scale;
            Wings.Velocity = math.rotate(pose.rotation, (float3)loop.velocity) * pose.scale;
            Wings.AngularVelocity = math.rotate(pose.rotation, (float3)loop.angularVelocity);
            m_Flyer.loop = loop;
            m_Flyer.rate = pose.rate;
            Wings.Steering = loop.isFlown ? InsectSteering.Default : loop.steering;
            Wings.Steering.frequencyScale *= pose.rate;
            for (int k = 0; k < m_Amplitudes.Length; k++)
            {
                Wings.Wings[k].AmplitudeScale =
                    m_Amplitudes[k] * (loop.isFlown ? 1f : Wings.Wings[k].Side == WingSide.Left ? 1f + loop.roll : 1f - loop.roll);
            }
            float frequency = Wings.Frequency;
            if (!(frequency > 0f))
                return;

            // The picture of this frame is this frame's time ahead of the last one; the crowd's job adds its own.
            float ahead = seconds - Clocks.FrameStep * (1f - WingSystem.Loop.DrawnAlpha(WingUpdateMode.Update));
            float own = math.lerp(baked.LoopAt(pose.loop).frequency, baked.LoopAt(pose.nextLoop).frequency, pose.blend);
            pose.phase = Wings.Phase / 360f + frequency * ahead - seconds * pose.rate * own;
            poses[Insect] = pose;
            m_Beats += frequency * seconds;
            if (m_Beats >= beatsToSettle)
                Show(true);
        }

        /// <summary>Destroys the live insect.</summary>
        public void Destroy()
        {
            if (Wings != null)
                ObjectEnd.Destroy(Wings.gameObject);
        }

        private static bool CanShow(in CrowdPose pose) =>
            math.all(math.isfinite(pose.position)) && math.all(math.isfinite(pose.rotation.value)) && math.isfinite(pose.scale);

        private void Show(bool shown)
        {
            IsShown = shown;
            foreach (Renderer renderer in m_Renderers)
            {
                if (renderer != null)
                    renderer.enabled = shown;
            }
        }
    }
}
