namespace Engraver.Core.SecondOpinions;

/// <summary>An entity with its tags, and the vertices that follow a POLYLINE.</summary>
internal sealed class SecondRecord(string type)
{
    public string Type { get; } = type;

    public List<SecondTag> Tags { get; } = [];

    public List<SecondRecord> Vertices { get; } = [];

    public bool InPaperSpace => Number(67, 0.0) == 1.0;

    public string Text(int code)
    {
        foreach (var tag in Tags)
        {
            if (tag.Code == code) return tag.Value.Trim();
        }

        return "";
    }

    public double Number(int code, double otherwise)
    {
        foreach (var tag in Tags)
        {
            if (tag.Code == code) return SecondTags.Number(tag.Value);
        }

        return otherwise;
    }

    public double[] Numbers(int code) => [.. Tags.Where(tag => tag.Code == code).Select(tag => SecondTags.Number(tag.Value))];

    public SecondPoint Point(int code) => new(Number(code, double.NaN), Number(code + 10, double.NaN), Number(code + 20, 0.0));
}
