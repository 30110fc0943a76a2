#if ALATE_SPLINES
using UnityEngine;
using UnityEngine.Splines;

namespace Alate.Flight
{
    /// <summary>Gives the Follow Pilot beside it points along a spline of com.unity.splines.</summary>
    [AddComponentMenu("Alate/Spline Path")]
    [RequireComponent(typeof(FollowPilot))]
    [DisallowMultipleComponent]
    public sealed class SplinePath : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("The spline to fly along.")]
        private SplineContainer m_Spline;

        [SerializeField]
        [Range(2, 500)]
        [Tooltip("Points along the spline, 2 to 500; 40.")]
        private int m_Points = 40;

        /// <summary>The spline to fly along.</summary>
        public SplineContainer Spline
        {
            get => m_Spline;
            set
            {
                m_Spline = value;
                Read();
            }
        }

        /// <summary>Takes the spline as it is now; called when the component starts.</summary>
        public void Read()
        {
            if (m_Spline == null)
                return;
            var pilot = GetComponent<FollowPilot>();
            bool closed = m_Spline.Spline.Closed;
            pilot.Origin = null;
            pilot.Loop = closed;
            pilot.Points.Clear();
            for (int k = 0; k < m_Points; k++)
                pilot.Points.Add((Vector3)m_Spline.EvaluatePosition(k / (closed ? (float)m_Points : m_Points - 1f)));
            pilot.Restart();
        }

        private void OnEnable() => Read();
    }
}
#endif
