namespace Alate.Wake
{
    /// <summary>Part of a wake that lift and drag coefficients hold: of the wing on which they were measured.</summary>
    public enum MeasuredDownwash
    {
        /// <summary>
        /// An angle of 0.15 C_L cos α: returns the lift of the measured wing within 5 % up to 30° of attack, and is 17 % low at 50°.
        /// </summary>
        Angle,

        /// <summary>
        /// Angle and size of the force of the revolving wing of Dickinson, Lehmann and Sane 1999, from a flight of that wing with its wake:
        /// returns both of its coefficients within 3 % from 10 to 80°.
        /// </summary>
        RevolvingWing,

        /// <summary>Nothing: coefficients of a section. With those of a whole wing its own downwash counts twice.</summary>
        None,
    }
}
