namespace Alate.Wake
{
    /// <summary>A wing that sheds a wake.</summary>
    public sealed class WakeWing
    {
        /// <summary>A wing with a motion.</summary>
        public WakeWing(IWingMotion motion) => Motion = motion;

        /// <summary>A wing with a motion, whose strips meet the air as the model does.</summary>
        /// <param name="motion">Its motion.</param>
        /// <param name="options">Of the model.</param>
        public WakeWing(IWingMotion motion, in ModelOptions options)
        {
            Motion = motion;
            Coefficients = options.coefficients;
            AttachedRotation = options.attachedRotation;
        }

        /// <summary>Its motion.</summary>
        public IWingMotion Motion { get; }

        /// <summary>Coefficients of its strips; null for a thin plate in attached flow, 2π sin α.</summary>
        public CoefficientSet? Coefficients { get; set; } = CoefficientSet.Dickinson1999;

        /// <summary>Part of a wake that these coefficients hold; it is taken out, so that it does not count twice.</summary>
        public MeasuredDownwash Downwash { get; set; }

        /// <summary>
        /// True where strips that turn about the span meet the air of their three-quarter chord, as far as the flow is attached; see
        /// <see cref="ModelOptions.attachedRotation"/>. Panels need no such term.
        /// </summary>
        public bool AttachedRotation { get; set; }

        /// <summary>False where its root lies on the plane of symmetry, so that the wing goes on in its mirror image.</summary>
        public bool FreeRoot { get; set; } = true;
    }
}
