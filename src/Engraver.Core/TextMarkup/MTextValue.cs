namespace Engraver.Core.TextMarkup;

/// <summary>A height or width that is stated, or a multiple of the inherited one. <c>default</c> is not valid; see <see cref="Inherited"/>.</summary>
/// <param name="Stated">Null where it is inherited: from the entity (height) or the style (width).</param>
/// <param name="Factor">Product of the relative codes (\H2x;) after it.</param>
public readonly record struct MTextValue(double? Stated, double Factor)
{
    public static MTextValue Inherited { get; } = new(null, 1.0);

    /// <param name="inherited">The value of the entity or the style.</param>
    public double Resolved(double inherited) => (Stated ?? inherited) * Factor;
}
