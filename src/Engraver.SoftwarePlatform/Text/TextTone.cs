namespace Engraver.SoftwarePlatform.Text;

/// <summary>Brightness of text: dark, middle and light text need different coverage to look equally heavy.</summary>
internal readonly record struct TextTone(int Level)
{
    private const int Levels = 4;

    /// <summary>Assumed gamma of the display. Real ones are between this and 2.2; a smaller value keeps thin strokes of light text from looking too
    /// thick.</summary>
    private const double Gamma = 1.4;

    /// <summary>Factor by which dark text is strengthened.</summary>
    private const double Contrast = 0.35;

    private static readonly byte[][] s_tables = [.. Enumerable.Range(0, Levels).Select(level => Table(level / (Levels - 1.0)))];

    public static TextTone Middle => new(1);

    /// <param name="pixel">Premultiplied colour of the text.</param>
    public static TextTone From(uint pixel)
    {
        var alpha = pixel >> 24;
        if (alpha == 0)
            return Middle;
        var brightness = (0.2126 * ((pixel >> 16) & 255) + 0.7152 * ((pixel >> 8) & 255) + 0.0722 * (pixel & 255)) / alpha;
        return new TextTone((int)Math.Round(Math.Clamp(brightness, 0, 1) * (Levels - 1)));
    }

    /// <summary>Coverage to draw with instead of the exact one.</summary>
    public void Apply(Span<byte> coverage)
    {
        var table = s_tables[Level];
        foreach (ref var cell in coverage)
            cell = table[cell];
    }

    /// <summary>Mixes text and an opposite background in linear light, and returns the coverage that gives the same result with stored (gamma)
    /// values.</summary>
    private static byte[] Table(double brightness)
    {
        double text = brightness, background = 1 - brightness;
        double textLight = Math.Pow(text, Gamma), backgroundLight = Math.Pow(background, Gamma);
        var strengthening = Contrast * backgroundLight;
        var table = new byte[256];
        for (var i = 0; i < table.Length; i++)
        {
            var coverage = i / 255.0;
            coverage += (1 - coverage) * strengthening * coverage;
            var mixed = Math.Pow(textLight * coverage + backgroundLight * (1 - coverage), 1 / Gamma);
            if (Math.Abs(text - background) > 0.01)
                coverage = (mixed - background) / (text - background);
            table[i] = (byte)Math.Round(Math.Clamp(coverage, 0, 1) * 255);
        }
        return table;
    }
}
