using System.Globalization;
using Engraver.Core.Drawings;

namespace Engraver.Core.Operations;

/// <summary>The curves that an operation takes: those on one of the layers, of one of the colours, or with one of the handles. Selections of several operations
/// may overlap.</summary>
public sealed record OperationSelection
{
    /// <summary>Everything that no other operation names.</summary>
    public static OperationSelection Rest { get; } = new() { IsRest = true };

    public bool IsRest { get; private init; }

    /// <summary>Names of layers, case-insensitive.</summary>
    public IReadOnlyList<string> Layers { get; init; } = [];

    /// <summary>Effective colours: an index of the AutoCAD palette (1 to 255) or RRGGBB, as text.</summary>
    public IReadOnlyList<string> Colours { get; init; } = [];

    /// <summary>Handles, hexadecimal.</summary>
    public IReadOnlyList<string> Handles { get; init; } = [];

    /// <summary>The selection with other handles; one for which there is none remains, so that its absence is reported.</summary>
    internal OperationSelection WithHandles(Func<string, IReadOnlyList<string>> written) => this with { Handles = [.. Handles.SelectMany(handle => written(handle) is { Count: > 0 } others ? others : [handle]).Distinct()] };

    /// <summary>For each entity of a drawing, true when it is named; for the rest, false.</summary>
    public Func<int, bool> NamedIn(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        bool[] layers = [.. drawing.Layers.Select(layer => Layers.Contains(layer.Name, StringComparer.OrdinalIgnoreCase))];
        var colours = Colours.ToHashSet(StringComparer.OrdinalIgnoreCase);
        var handles = Handles.Select(handle => ulong.Parse(handle, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture)).ToHashSet();
        return entity => layers[drawing.Entities[entity].Layer] || (colours.Count > 0 && colours.Contains(NameOf(drawing.ColourOf(entity)))) || (handles.Count > 0 && handles.Contains(drawing.Entities[entity].Handle));
    }

    /// <summary>The layers that the drawing does not have.</summary>
    public IReadOnlyList<string> UnknownLayers(Drawing drawing) => [.. Layers.Where(name => !drawing.Layers.Any(layer => string.Equals(layer.Name, name, StringComparison.OrdinalIgnoreCase)))];

    /// <summary>The handles that no curve of the drawing has.</summary>
    public IReadOnlyList<string> UnknownHandles(Drawing drawing) => [.. Handles.Where(handle => drawing.IndexOfHandle(handle) is null)];

    /// <summary>True for a hexadecimal number above 0.</summary>
    internal static bool IsHandle(string text) => ulong.TryParse(text, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var number) && number > 0;

    /// <summary>True for a text that names a colour.</summary>
    internal static bool IsColour(string text) =>
        text.Length == 6 ? int.TryParse(text, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out _) : int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var index) && index is >= 1 and <= 255 && text[0] != '0';

    private static string NameOf(DrawingColour colour) => colour.Rgb is { } rgb ? rgb.ToString("X6", CultureInfo.InvariantCulture) : colour.Index?.ToString(CultureInfo.InvariantCulture) ?? "";
}
