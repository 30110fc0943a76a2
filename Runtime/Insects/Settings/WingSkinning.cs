namespace Alate
{
    /// <summary>Choice of what deforms the meshes of an insect's wings.</summary>
    public enum WingSkinning
    {
        /// <summary>The processor: works on every device and with every shader, and scripts can read the vertices.</summary>
        Cpu,

        /// <summary>
        /// The graphics card, in the vertex shader; the processor where that cannot be, with a warning that says why.
        /// </summary>
        Gpu,

        /// <summary>The graphics card where it can, else the processor, without a warning.</summary>
        Automatic,
    }
}
