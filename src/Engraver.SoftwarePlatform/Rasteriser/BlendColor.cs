namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>Three channels from 0 to 1.</summary>
internal readonly record struct BlendColor(float Red, float Green, float Blue)
{
    public float Luminosity => 0.3f * Red + 0.59f * Green + 0.11f * Blue;

    public float Saturation => Highest - Lowest;

    public float Highest => Math.Max(Red, Math.Max(Green, Blue));

    public float Lowest => Math.Min(Red, Math.Min(Green, Blue));

    public static BlendColor operator +(BlendColor a, BlendColor b) => new(a.Red + b.Red, a.Green + b.Green, a.Blue + b.Blue);

    public static BlendColor operator *(BlendColor color, float factor) => new(color.Red * factor, color.Green * factor, color.Blue * factor);
}
