using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// The beat that flight controllers command, in place of the one that follows the body's speed (Eq. 6, 7); lane = wing. Latched at the
    /// next beat.
    /// </summary>
    internal struct LaneDrive
    {
        /// <summary>1 where a wing is commanded, else 0.</summary>
        public float4 commanded;

        /// <summary>Frequency, hertz.</summary>
        public float4 frequency;

        /// <summary>Factor on the amplitudes of the parameters.</summary>
        public float4 amplitude;

        /// <summary>Added to the middle of the stroke, radians: x tilt (nose up), y sweep (ahead), z feather.</summary>
        public SoaFloat3 means;

        /// <summary>Added to the middle of the stroke, radians up.</summary>
        public float4 meanFlap;

        /// <summary>One wing's command.</summary>
        public WingDrive Of(int lane) => new WingDrive
        {
            frequency = frequency[lane],
            amplitude = amplitude[lane],
            meanFlap = meanFlap[lane],
            tilt = means.x[lane],
            meanSweep = means.y[lane],
            meanFeather = means.z[lane],
        };

        /// <summary>Writes one wing's command, or releases the wing.</summary>
        public void Set(int lane, in WingDrive drive, bool isCommanded)
        {
            commanded[lane] = isCommanded ? 1f : 0f;
            frequency[lane] = drive.frequency;
            amplitude[lane] = drive.amplitude;
            meanFlap[lane] = drive.meanFlap;
            means[lane] = new float3(drive.tilt, drive.meanSweep, drive.meanFeather);
        }
    }
}
