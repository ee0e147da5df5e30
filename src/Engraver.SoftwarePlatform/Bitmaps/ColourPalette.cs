namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>Chooses at most 256 colours for a picture: first the frequent ones, then those farthest from the chosen ones, so that each colour is close to its
/// substitute.</summary>
internal sealed class ColourPalette
{
    public const int MaxColours = 256;
    private const int Frequent = 160;
    private readonly Dictionary<uint, byte> _places = [];
    private readonly List<uint> _colours = [];

    private ColourPalette(Dictionary<uint, int> counts)
    {
        var byCount = counts.OrderByDescending(colour => colour.Value).ThenBy(colour => colour.Key).Select(colour => colour.Key).ToList();
        _colours.AddRange(byCount.Take(counts.Count <= MaxColours ? MaxColours : Frequent));
        var distances = byCount.Select(colour => (Colour: colour, Distance: _colours.Min(chosen => Distance(chosen, colour)))).ToArray();
        while (_colours.Count < Math.Min(MaxColours, counts.Count)) AddFarthest(distances);
        for (var i = 0; i < _colours.Count; i++) _places[_colours[i]] = (byte)i;
    }

    /// <summary>Red in the lowest byte, as <see cref="PngFile"/> writes them.</summary>
    public IReadOnlyList<uint> Colours => _colours;

    /// <param name="pixels">Red in the lowest byte.</param>
    public static ColourPalette From(ReadOnlySpan<uint> pixels)
    {
        var counts = new Dictionary<uint, int>();
        foreach (var pixel in pixels) counts[pixel] = counts.GetValueOrDefault(pixel) + 1;
        return new ColourPalette(counts);
    }

    /// <summary>Index of the colour itself, or of the nearest one.</summary>
    public byte PlaceOf(uint colour)
    {
        if (_places.TryGetValue(colour, out var place)) return place;
        for (var i = 1; i < _colours.Count; i++)
        {
            if (Distance(_colours[i], colour) < Distance(_colours[place], colour)) place = (byte)i;
        }

        return _places[colour] = place;
    }

    private void AddFarthest((uint Colour, int Distance)[] distances)
    {
        var farthest = distances.MaxBy(colour => colour.Distance).Colour;
        _colours.Add(farthest);
        for (var i = 0; i < distances.Length; i++) distances[i].Distance = Math.Min(distances[i].Distance, Distance(farthest, distances[i].Colour));
    }

    private static int Distance(uint a, uint b)
    {
        var (red, green, blue) = ((int)(a & 0xFF) - (int)(b & 0xFF), (int)((a >> 8) & 0xFF) - (int)((b >> 8) & 0xFF), (int)((a >> 16) & 0xFF) - (int)((b >> 16) & 0xFF));
        return (red * red) + (green * green) + (blue * blue);
    }
}
