using System.Globalization;
using Engraver.Core.Drawings;

namespace Engraver.Core.Operations;

/// <summary>The curves that an operation takes: those on one of the layers, of one of the colours or linetypes, from one of the blocks, or with one of the
/// handles. Selections of several operations may overlap.</summary>
public sealed record OperationSelection
{
    /// <summary>Everything that no other operation names.</summary>
    public static OperationSelection Rest { get; } = new() { IsRest = true };

    public bool IsRest { get; private init; }

    /// <summary>Names of layers, case-insensitive.</summary>
    public IReadOnlyList<string> Layers { get; init; } = [];

    /// <summary>Effective colours: an index of the AutoCAD palette (1 to 255) or RRGGBB, as text.</summary>
    public IReadOnlyList<string> Colours { get; init; } = [];

    /// <summary>Effective linetypes, case-insensitive.</summary>
    public IReadOnlyList<string> Linetypes { get; init; } = [];

    /// <summary>Names of blocks, case-insensitive: what is inserted with them, at any depth.</summary>
    public IReadOnlyList<string> Blocks { get; init; } = [];

    /// <summary>Handles, hexadecimal.</summary>
    public IReadOnlyList<string> Handles { get; init; } = [];

    /// <summary>Nothing is named.</summary>
    internal bool IsEmpty => !IsRest && Layers.Count + Colours.Count + Linetypes.Count + Blocks.Count + Handles.Count == 0;

    /// <summary>The selection with other handles; one for which there is none remains, so that its absence is reported.</summary>
    internal OperationSelection WithHandles(Func<string, IReadOnlyList<string>> written) => this with { Handles = [.. Handles.SelectMany(handle => written(handle) is { Count: > 0 } others ? others : [handle]).Distinct()] };

    /// <summary>What of a drawing is named; nothing for the rest.</summary>
    internal SelectedContent In(Drawing drawing) => new(this, drawing);

    /// <summary>The layers that the drawing does not have.</summary>
    public IReadOnlyList<string> UnknownLayers(Drawing drawing) => [.. Layers.Where(name => !drawing.Layers.Any(layer => string.Equals(layer.Name, name, StringComparison.OrdinalIgnoreCase)))];

    /// <summary>The linetypes that the drawing does not have.</summary>
    public IReadOnlyList<string> UnknownLinetypes(Drawing drawing) => [.. Linetypes.Except(LinetypesOf(drawing), StringComparer.OrdinalIgnoreCase)];

    /// <summary>The blocks that the drawing does not have.</summary>
    public IReadOnlyList<string> UnknownBlocks(Drawing drawing) => [.. Blocks.Except(BlocksOf(drawing), StringComparer.OrdinalIgnoreCase)];

    /// <summary>The linetypes that a selection can name.</summary>
    public static IReadOnlyList<string> LinetypesOf(Drawing drawing) => [.. drawing.Linetypes.Skip(Linetype.Continuous).Select(linetype => linetype.Name)];

    /// <summary>The blocks that a selection can name: those of the spaces are not inserted.</summary>
    public static IReadOnlyList<string> BlocksOf(Drawing drawing) => [.. drawing.Blocks.Where(block => !block.Contains("_SPACE", StringComparison.OrdinalIgnoreCase))];

    /// <summary>The handles that no curve and no point of the drawing has.</summary>
    public IReadOnlyList<string> UnknownHandles(Drawing drawing) => [.. Handles.Where(handle => drawing.IndexOfHandle(handle) is null && !drawing.Points.Any(point => point.Handle == NumberOf(handle)))];

    /// <summary>True for a hexadecimal number above 0.</summary>
    internal static bool IsHandle(string text) => ulong.TryParse(text, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var number) && number > 0;

    /// <summary>True for a text that names a colour.</summary>
    internal static bool IsColour(string text) =>
        text.Length == 6 ? int.TryParse(text, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out _) : int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var index) && index is >= 1 and <= 255 && text[0] != '0';

    /// <summary>The number of a handle.</summary>
    internal static ulong NumberOf(string handle) => ulong.Parse(handle, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture);

    /// <summary>A colour as a selection names it.</summary>
    internal static string NameOf(DrawingColour colour) => colour.Rgb is { } rgb ? rgb.ToString("X6", CultureInfo.InvariantCulture) : colour.Index?.ToString(CultureInfo.InvariantCulture) ?? "";
}
