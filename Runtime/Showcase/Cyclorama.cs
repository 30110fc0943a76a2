using System.Collections.Generic;
using UnityEngine;

namespace Alate.Showcase
{
    /// <summary>
    /// Floor and walls that run into one another, as in a photographer's studio: a plain ground on which shadows fall, wherever the
    /// camera stands. From outside nothing of it is seen. <see cref="Create"/> makes one around what an <see cref="OrbitCamera"/> looks
    /// at.
    /// </summary>
    [AddComponentMenu("")]
    [DisallowMultipleComponent]
    public sealed class Cyclorama : MonoBehaviour
    {
        private const int k_Sides = 48, k_Steps = 10;

        /// <summary>Radius in distances of the camera; radius of the bend and height of the dome above it, in those radii.</summary>
        private const float k_Radius = 4f, k_Bend = 0.5f, k_Dome = 0.9f;

        private static readonly Color s_Floor = new Color(0.8f, 0.81f, 0.8f), s_Top = new Color(0.6f, 0.67f, 0.7f);

        private Mesh m_Mesh;
        private Material m_Material;

        /// <summary>Makes one beside a camera, and lets the lamp that hangs on the camera cast soft shadows.</summary>
        /// <param name="camera">The camera; four times its distance is the radius.</param>
        /// <param name="below">World units from the camera's target down to the floor, more than 0.</param>
        /// <param name="material">Material that shows vertex colours and hides back faces; it ends with the walls.</param>
        /// <exception cref="System.ArgumentNullException">There is no camera or no material.</exception>
        /// <exception cref="System.ArgumentOutOfRangeException">The floor is not below the target.</exception>
        public static Cyclorama Create(OrbitCamera camera, float below, Material material)
        {
            if (camera == null)
                throw new System.ArgumentNullException(nameof(camera));
            if (material == null)
                throw new System.ArgumentNullException(nameof(material));
            if (!(below > 0f && below < float.PositiveInfinity))
                throw new System.ArgumentOutOfRangeException(nameof(below), below, "The floor lies some world units below the target.");
            var made = new GameObject("Cyclorama");
            made.transform.SetParent(camera.transform.parent, false);
            made.transform.SetPositionAndRotation(camera.Target - below * Vector3.up, Quaternion.identity);
            Cyclorama walls = made.AddComponent<Cyclorama>();
            walls.m_Material = material;
            made.AddComponent<MeshFilter>().sharedMesh = walls.m_Mesh = Walls(k_Radius * camera.Distance);
            MeshRenderer shown = made.AddComponent<MeshRenderer>();
            shown.sharedMaterial = material;
            shown.shadowCastingMode = UnityEngine.Rendering.ShadowCastingMode.Off;
            Light lamp = camera.GetComponentInChildren<Light>();
            if (lamp != null)
                lamp.shadows = LightShadows.Soft;
            return walls;
        }

        private void OnDestroy()
        {
            Destroy(m_Mesh);
            Destroy(m_Material);
        }

        // Rings around the middle, from that of the floor to that of the dome; triangles are seen from inside.
        private static Mesh Walls(float radius)
        {
            List<Vector2> profile = Profile();
            const int row = k_Sides + 1;
            var places = new Vector3[row * profile.Count];
            var normals = new Vector3[places.Length];
            var colours = new Color32[places.Length];
            for (int k = 0; k < places.Length; k++)
            {
                int ring = k / row;
                Vector2 at = profile[ring], along = profile[Mathf.Min(ring + 1, profile.Count - 1)] - profile[Mathf.Max(ring - 1, 0)];
                float angle = 2f * Mathf.PI * (k % row) / k_Sides;
                var outward = new Vector3(Mathf.Cos(angle), 0f, Mathf.Sin(angle));
                places[k] = radius * (at.x * outward + at.y * Vector3.up);
                normals[k] = (along.x * Vector3.up - along.y * outward).normalized;
                colours[k] = Color.Lerp(s_Floor, s_Top, at.y / profile[profile.Count - 1].y);
            }

            var triangles = new List<int>(6 * places.Length);
            for (int k = 0; k < places.Length - row - 1; k++)
            {
                if (k % row == k_Sides)
                    continue;
                if (k >= row)
                    triangles.AddRange(new[] { k, k + 1, k + row + 1 });
                if (k < places.Length - 2 * row)
                    triangles.AddRange(new[] { k, k + row + 1, k + row });
            }

            var mesh = new Mesh { name = "Cyclorama", vertices = places, normals = normals, colors32 = colours };
            mesh.triangles = triangles.ToArray();
            mesh.RecalculateBounds();
            return mesh;
        }

        // Out and up in radii: a floor, a quarter of a circle, a quarter of an ellipse.
        private static List<Vector2> Profile()
        {
            var profile = new List<Vector2> { Vector2.zero, new Vector2(0.5f * (1f - k_Bend), 0f) };
            for (int k = 0; k <= k_Steps; k++)
            {
                float angle = 0.5f * Mathf.PI * k / k_Steps;
                profile.Add(new Vector2(1f - k_Bend * (1f - Mathf.Sin(angle)), k_Bend * (1f - Mathf.Cos(angle))));
            }

            for (int k = 1; k <= k_Steps; k++)
            {
                float angle = 0.5f * Mathf.PI * k / k_Steps;
                profile.Add(new Vector2(k < k_Steps ? Mathf.Cos(angle) : 0f, k_Bend + k_Dome * Mathf.Sin(angle)));
            }

            return profile;
        }
    }
}
