using System.Collections.Generic;

namespace UnityEngine;

public sealed class Camera : Behaviour, IStateful
{
    /// <summary>Raised for each camera that draws, before it looks for what it sees; by the built-in pipeline alone.</summary>
    public static CameraCallback onPreCull;

    private static readonly List<Camera> s_Living = [];
    private readonly Matrix4x4[] _eyeViews = new Matrix4x4[2], _eyeProjections = new Matrix4x4[2];
    private Matrix4x4? _cullingMatrix;

    public Camera() => s_Living.Add(this);

    public delegate void CameraCallback(Camera cam);

    public enum StereoscopicEye
    {
        Left = 0,
        Right = 1,
    }

    public static Camera main => s_Living.Find(c => c.IsUsed && c.Owner.CompareTag("MainCamera"));
    public static Camera current => null;
    public static Camera[] allCameras => [.. s_Living.FindAll(c => c.IsUsed)];
    public static int allCamerasCount
    {
        get
        {
            int count = 0;
            foreach (Camera camera in s_Living)
                count += camera.IsUsed ? 1 : 0;
            return count;
        }
    }

    /// <summary>Degrees from the lower to the upper edge.</summary>
    public float fieldOfView { get; set; } = 60f;
    public float nearClipPlane { get; set; } = 0.3f;
    public float farClipPlane { get; set; } = 1000f;
    public bool orthographic { get; set; }
    public float orthographicSize { get; set; } = 5f;
    public float aspect { get; set; } = (float)Screen.width / Screen.height;
    public int cullingMask { get; set; } = -1;
    public float depth { get; set; }
    public CameraType cameraType { get; set; } = CameraType.Game;
    public CameraClearFlags clearFlags { get; set; } = CameraClearFlags.Skybox;
    public Color backgroundColor { get; set; } = new(0.19f, 0.3f, 0.47f, 0f);
    public RenderTexture targetTexture { get; set; }
    public int pixelWidth => Screen.width;
    public int pixelHeight => Screen.height;

    public Matrix4x4 projectionMatrix => orthographic
        ? Matrix4x4.Ortho(
            -orthographicSize * aspect, orthographicSize * aspect, -orthographicSize, orthographicSize, nearClipPlane, farClipPlane)
        : Matrix4x4.Perspective(fieldOfView, aspect, nearClipPlane, farClipPlane);

    /// <summary>Matrix without the transform's scale; the camera looks along -z of its own space.</summary>
    public Matrix4x4 worldToCameraMatrix =>
        Matrix4x4.Scale(new Vector3(1f, 1f, -1f)) * Matrix4x4.TRS(transform.position, transform.rotation, Vector3.one).inverse;

    /// <summary>World to the picture, as culled for; the camera's own unless it was set.</summary>
    public Matrix4x4 cullingMatrix
    {
        get => _cullingMatrix ?? projectionMatrix * worldToCameraMatrix;
        set => _cullingMatrix = value;
    }

    /// <summary>Scenes that the camera draws alone, a bit each; 0 for those that are loaded.</summary>
    public ulong overrideSceneCullingMask { get; set; }

    /// <summary>True once both eyes have matrices: there is no headset here.</summary>
    public bool stereoEnabled => _eyeProjections[0] != default && _eyeProjections[1] != default;

    internal static IReadOnlyList<Camera> Living => s_Living;

    internal bool IsUsed => EnabledFlag && Owner is { ActiveFlag: true };

    public static int GetAllCameras(Camera[] cameras)
    {
        int count = 0;
        foreach (Camera camera in s_Living)
        {
            if (camera.IsUsed)
                cameras[count++] = camera;
        }

        return count;
    }

    /// <summary>Draws nothing.</summary>
    public void Render()
    {
    }

    public void ResetCullingMatrix() => _cullingMatrix = null;

    public Matrix4x4 GetStereoViewMatrix(StereoscopicEye eye) => _eyeViews[(int)eye];

    public Matrix4x4 GetStereoProjectionMatrix(StereoscopicEye eye) => _eyeProjections[(int)eye];

    public void SetStereoViewMatrix(StereoscopicEye eye, Matrix4x4 matrix) => _eyeViews[(int)eye] = matrix;

    public void SetStereoProjectionMatrix(StereoscopicEye eye, Matrix4x4 matrix) => _eyeProjections[(int)eye] = matrix;

    public Vector3 WorldToViewportPoint(Vector3 position)
    {
        Vector3 seen = worldToCameraMatrix.MultiplyPoint3x4(position);
        Vector3 clip = projectionMatrix.MultiplyPoint(seen);
        return new Vector3(0.5f + 0.5f * clip.x, 0.5f + 0.5f * clip.y, -seen.z);
    }

    public Vector3 WorldToScreenPoint(Vector3 position) =>
        Vector3.Scale(WorldToViewportPoint(position), new Vector3(pixelWidth, pixelHeight, 1f));

    void IStateful.CopyStateTo(Component copy)
    {
        var to = (Camera)copy;
        to.fieldOfView = fieldOfView;
        to.nearClipPlane = nearClipPlane;
        to.farClipPlane = farClipPlane;
        to.orthographic = orthographic;
        to.orthographicSize = orthographicSize;
        to.aspect = aspect;
        to.cullingMask = cullingMask;
    }

    private protected override void Released() => s_Living.Remove(this);
}

public enum CameraType
{
    Game = 1,
    SceneView = 2,
    Preview = 4,
    VR = 8,
    Reflection = 16,
}

public enum CameraClearFlags
{
    Skybox = 1,
    Color = 2,
    SolidColor = 2,
    Depth = 3,
    Nothing = 4,
}

public sealed class Screen
{
    public static int width => 1920;
    public static int height => 1080;
    public static float dpi => Unity.StandIns.ShownScreen.Dpi;
}
