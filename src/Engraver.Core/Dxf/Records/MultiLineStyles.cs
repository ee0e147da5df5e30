using System.Text;
using Engraver.Core.Dxf.Tags;

namespace Engraver.Core.Dxf.Records;

/// <summary>The flags of the MLINESTYLE objects of a file: which caps and joints its multilines have. They come after the entities, so they are looked up
/// first.</summary>
internal sealed class MultiLineStyles
{
    private readonly Dictionary<string, int> _flags = new(StringComparer.OrdinalIgnoreCase);

    /// <summary>Flags of a style (group 70); 0, no caps, for one that the file does not define.</summary>
    public MultiLineStyleFlags this[string name] => (MultiLineStyleFlags)_flags.GetValueOrDefault(name);

    /// <summary>Reads the whole file once and returns to the starting position.</summary>
    public static MultiLineStyles Read(DxfTagSource tags, CancellationToken cancellation)
    {
        var styles = new MultiLineStyles();
        var start = tags.Bookmark();
        string? name = null;
        var inside = false;
        while (tags.Read())
        {
            if (tags.Code == 0)
            {
                cancellation.ThrowIfCancellationRequested();
                inside = tags.Value.Trim(" \t"u8).SequenceEqual("MLINESTYLE"u8);
                name = null;
            }
            else if (inside && tags.Code == 2) name = Encoding.Latin1.GetString(tags.Value).Trim();
            else if (inside && tags.Code == 70 && name is not null && tags.TryNumber(out var flags)) styles._flags.TryAdd(name, (int)flags);
        }

        tags.Return(start);
        return styles;
    }
}
