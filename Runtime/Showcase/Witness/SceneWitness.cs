using System;
using System.Globalization;
using System.IO;
using UnityEngine;

namespace Alate.Showcase
{
    /// <summary>
    /// Watches a scene that plays for a proof: takes pictures by its camera at fixed times, counts errors and frames, writes an account,
    /// and ends a player. Without <see cref="Folder"/> the command line names it: <c>-proofOut DIR</c>.
    /// </summary>
    [AddComponentMenu("")]
    internal sealed class SceneWitness : MonoBehaviour
    {
        private const string k_FolderArgument = "-proofOut";
        private const int k_Width = 960, k_Height = 540, k_DepthBits = 24;
        private const float k_Milliseconds = 1000f;

        [SerializeField] private string m_Folder = "";
        [SerializeField] private string m_SceneName = "";
        [SerializeField] private float[] m_Times = Array.Empty<float>();

        private readonly SceneAccount m_Account = new SceneAccount();
        private float m_Time, m_FrameTime;

        /// <summary>True after the account of the scene that plays is written.</summary>
        public static bool IsDone { get; private set; }

        /// <summary>Folder of pictures and account; empty for that of the command line.</summary>
        public string Folder
        {
            set => m_Folder = value;
        }

        /// <summary>Name of the scene, with which the files begin.</summary>
        public string SceneName
        {
            set => m_SceneName = value;
        }

        /// <summary>Seconds of play at which pictures are taken, ascending; the last one ends it.</summary>
        public float[] Times
        {
            set => m_Times = value;
        }

        private void OnEnable()
        {
            IsDone = false;
            Application.logMessageReceived += Count;
        }

        private void OnDisable() => Application.logMessageReceived -= Count;

        // After all scripts that move cameras and insects: this is the last of a frame to draw.
        private void LateUpdate()
        {
            if (m_Account.pictures == m_Times.Length)
                return;
            m_Time += Time.deltaTime;
            m_FrameTime += Time.unscaledDeltaTime;
            m_Account.frames++;
            if (m_Time < m_Times[m_Account.pictures])
                return;
            Take();
            if (m_Account.pictures == m_Times.Length)
                End();
        }

        private void Take()
        {
            string name = string.Format(CultureInfo.InvariantCulture, "{0} {1:00.#} s.png", m_SceneName, m_Times[m_Account.pictures]);
            m_Account.pictures++;
            Camera eye = Camera.main != null ? Camera.main : FindAnyObjectByType<Camera>();
            if (eye == null)
            {
                m_Account.blank++;
                return;
            }

            Texture2D picture = See(eye);
            Color32[] pixels = picture.GetPixels32();
            if (Array.TrueForAll(pixels, pixel => pixel.Equals(pixels[0])))
                m_Account.blank++;
            File.WriteAllBytes(Path.Combine(Where(), name), picture.EncodeToPNG());
            Destroy(picture);
        }

        private static Texture2D See(Camera eye)
        {
            RenderTexture target = RenderTexture.GetTemporary(k_Width, k_Height, k_DepthBits), before = eye.targetTexture;
            RenderTexture active = RenderTexture.active;
            var picture = new Texture2D(k_Width, k_Height, TextureFormat.RGBA32, false);
            eye.targetTexture = target;
            eye.Render();
            eye.targetTexture = before;
            RenderTexture.active = target;
            picture.ReadPixels(new Rect(0f, 0f, k_Width, k_Height), 0, 0);
            picture.Apply();
            RenderTexture.active = active;
            RenderTexture.ReleaseTemporary(target);
            return picture;
        }

        private void End()
        {
            m_Account.milliseconds = k_Milliseconds * m_FrameTime / m_Account.frames;
            m_Account.Write(Where(), m_SceneName);
            IsDone = true;
            if (!Application.isEditor)
                Application.Quit();
        }

        private void Count(string condition, string stackTrace, LogType type)
        {
            if (type == LogType.Log || type == LogType.Warning)
                return;
            m_Account.errors++;
            if (m_Account.errors == 1)
                m_Account.firstError = condition;
        }

        private string Where()
        {
            if (m_Folder.Length > 0)
                return m_Folder;
            string[] arguments = Environment.GetCommandLineArgs();
            int at = Array.IndexOf(arguments, k_FolderArgument);
            return at >= 0 && at + 1 < arguments.Length ? arguments[at + 1] : Application.persistentDataPath;
        }
    }
}
