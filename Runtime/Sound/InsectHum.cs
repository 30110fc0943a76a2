using UnityEngine;

namespace Alate.Sound
{
    /// <summary>
    /// The sound of an insect's wings, from the beat that they fly: its frequency, the overtones of the air's force, and as loud as the
    /// power that the air takes. Silent while the wings are not computed or time stands still. Distance and direction are those of the
    /// Audio Source beside it, which plays a clip of ones that is made here; no asset is needed.
    /// </summary>
    [AddComponentMenu("Alate/Insect Hum")]
    [DefaultExecutionOrder(ExecutionOrders.AfterWings)]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(AudioSource))]
    public sealed class InsectHum : MonoBehaviour
    {
        /// <summary>Speed of sound, metres a second: dry air at 20 °C.</summary>
        public const float SpeedOfSound = 343f;

        /// <summary>Fastest approach that is heard, as a share of the speed of sound: jumps of a camera are no shrieks.</summary>
        private const float k_FastestApproach = 0.2f;

        /// <summary>Seconds between two looks for a listener, where there is none.</summary>
        private const double k_LookTime = 0.25;

        private const float k_Volume = 0.3f, k_LeastPower = 0.001f, k_FullPower = 20f, k_MostPower = 1000f;

        [SerializeField]
        [Tooltip("The insect that is heard. None: the one of this object or of its parents.")]
        private InsectWings m_Insect;

        [SerializeField]
        [Range(0f, 1f)]
        [Tooltip("Level of the sound at Full Power: 0 is silent, 1 as loud as can be.")]
        private float m_Volume = k_Volume;

        [SerializeField]
        [Range(k_LeastPower, k_MostPower)]
        [Tooltip("Power that the wings give to the air, mW, at which the sound has its volume; a quarter of it sounds half as strong.")]
        private float m_FullPower = k_FullPower;

        private readonly BeatSpectrum m_Beat = new BeatSpectrum();
        private readonly HumVoice m_Voice = new HumVoice();
        private AudioSource m_Source;
        private AudioClip m_Ones;
        private AudioListener m_Listener;
        private int m_SampleRate;
        private float m_Power, m_Distance;
        private double m_NextLook;
        private bool m_WasHeard, m_LoopedBefore;
        private AudioClip m_ClipBefore;

        /// <summary>The insect that is heard; null where there is none.</summary>
        public InsectWings Insect
        {
            get => m_Insect;
            set => m_Insect = value;
        }

        /// <summary>Level at <see cref="FullPower"/>, 0 to 1 (clamped).</summary>
        public float Volume
        {
            get => Within(m_Volume, 0f, 1f, k_Volume);
            set => m_Volume = Within(value, 0f, 1f, k_Volume);
        }

        /// <summary>Power to the air at which the sound has its volume, mW, 0.001 to 1000 (clamped).</summary>
        public float FullPower
        {
            get => Within(m_FullPower, k_LeastPower, k_MostPower, k_FullPower);
            set => m_FullPower = Within(value, k_LeastPower, k_MostPower, k_FullPower);
        }

        /// <summary>Frequency of the tone as it is heard, hertz: the beat's, times the time scale, and shifted by approach.</summary>
        public float Frequency { get; private set; }

        /// <summary>Root mean square of the sound before distance, 0 to 1.</summary>
        public float Level { get; private set; }

        private void OnEnable()
        {
            if (m_Insect == null)
                m_Insect = GetComponentInParent<InsectWings>();
            m_Source = GetComponent<AudioSource>();
            m_ClipBefore = m_Source.clip;
            m_LoopedBefore = m_Source.loop;
            m_WasHeard = false;
            m_NextLook = 0.0;
            AudioSettings.OnAudioConfigurationChanged += StartSource;
            StartSource(true);
        }

        private void OnDisable()
        {
            AudioSettings.OnAudioConfigurationChanged -= StartSource;
            m_Source.Stop();
            m_Source.clip = m_ClipBefore;
            m_Source.loop = m_LoopedBefore;
            ObjectEnd.Destroy(m_Ones);
            Frequency = Level = 0f;
        }

        // What the source does to a clip of ones, by distance and direction, is done to the tone by which it is multiplied.
        private void StartSource(bool deviceChanged)
        {
            m_SampleRate = AudioSettings.outputSampleRate;
            ObjectEnd.Destroy(m_Ones);
            float[] ones = new float[1024];
            System.Array.Fill(ones, 1f);
            m_Ones = AudioClip.Create("Ones", ones.Length, 1, m_SampleRate, false);
            m_Ones.SetData(ones, 0);
            m_Source.clip = m_Ones;
            m_Source.loop = true;
            m_Source.Play();
        }

        private void LateUpdate()
        {
            float seconds = Time.deltaTime;
            bool isHeard = m_Insect != null && m_Insect.State == InsectState.Ready && m_Insect.Detail != WingDetail.Frozen
                && seconds > 0f;
            if (isHeard)
                Listen(seconds);
            Level = isHeard ? Volume * Mathf.Sqrt(Mathf.Clamp01(1000f * m_Power / FullPower)) : 0f;
            m_WasHeard = isHeard;
            HumTone tone = m_Voice.Wanted;
            tone.frequency = Frequency;
            tone.level = Level;
            m_Beat.Read(tone.amplitudes);
            m_Voice.Say();
        }

        private void Listen(float seconds)
        {
            if (!m_WasHeard)
            {
                m_Beat.Clear();
                m_Power = Mathf.Max(m_Insect.AirPower, 0f);
            }

            float frequency = m_Insect.Frequency;
            m_Beat.Add(Mathf.Repeat(m_Insect.Phase / 360f, 1f), m_Insect.AirForce);
            m_Power += (m_Insect.AirPower - m_Power) * (1f - Mathf.Exp(-0.5f * frequency * seconds));
            m_Power = float.IsNaN(m_Power) ? 0f : Mathf.Max(m_Power, 0f);
            Frequency = frequency * Time.timeScale * Approach(Time.unscaledDeltaTime);
        }

        private float Approach(float seconds)
        {
            if (m_Listener == null)
                LookForListener();
            if (m_Listener == null)
                return 1f;
            float distance = Vector3.Distance(m_Listener.transform.position, transform.position);
            float receding = m_WasHeard && seconds > 0f ? (distance - m_Distance) / (seconds * SpeedOfSound) : 0f;
            m_Distance = distance;
            return 1f / (1f + m_Source.dopplerLevel * Mathf.Clamp(receding, -k_FastestApproach, k_FastestApproach));
        }

        // A key writes what it likes: what is no number would stay in the sound for good.
        private static float Within(float value, float least, float most, float none) =>
            float.IsNaN(value) ? none : Mathf.Clamp(value, least, most);

        // Not in every frame: it looks through the scene.
        private void LookForListener()
        {
            if (Time.unscaledTimeAsDouble < m_NextLook)
                return;
            m_NextLook = Time.unscaledTimeAsDouble + k_LookTime;
            m_Listener = FindAnyObjectByType<AudioListener>();
        }

        // Called by the engine on the thread of the sound.
        internal void OnAudioFilterRead(float[] data, int channels) => m_Voice.Multiply(data, channels, m_SampleRate);
    }
}
