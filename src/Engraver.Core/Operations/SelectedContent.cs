using Engraver.Core.Drawings;

namespace Engraver.Core.Operations;

/// <summary>What a selection names in a drawing.</summary>
internal sealed class SelectedContent
{
    private readonly Drawing _drawing;
    private readonly bool[] _layers;
    private readonly bool[] _linetypes;
    private readonly bool[] _blocks;
    private readonly bool[] _paths;
    private readonly HashSet<string> _colours;
    private readonly HashSet<ulong> _handles;

    public SelectedContent(OperationSelection selection, Drawing drawing)
    {
        _drawing = drawing;
        _layers = [.. drawing.Layers.Select(layer => selection.Layers.Contains(layer.Name, StringComparer.OrdinalIgnoreCase))];
        _linetypes = [.. drawing.Linetypes.Select(linetype => selection.Linetypes.Contains(linetype.Name, StringComparer.OrdinalIgnoreCase))];
        _colours = selection.Colours.ToHashSet(StringComparer.OrdinalIgnoreCase);
        _handles = [.. selection.Handles.Select(OperationSelection.NumberOf)];
        _blocks = [.. drawing.Blocks.Select(block => selection.Blocks.Contains(block, StringComparer.OrdinalIgnoreCase))];
        _paths = new bool[drawing.BlockPaths.Count];
        for (var path = 1; path < _paths.Length; path++) _paths[path] = _blocks[drawing.BlockPaths[path].Block] || _paths[drawing.BlockPaths[path].Around];
    }

    /// <summary>True for a named curve.</summary>
    public bool Has(int entity)
    {
        ref var drawn = ref _drawing.Entities[entity];
        return _layers[drawn.Layer] || (_handles.Count > 0 && _handles.Contains(drawn.Handle)) || (_colours.Count > 0 && _colours.Contains(OperationSelection.NameOf(_drawing.ColourOf(entity))))
            || _linetypes[_drawing.LinetypeOf(entity)] || IsOfBlock(entity);
    }

    /// <summary>True for a named point.</summary>
    public bool Has(in PlacedPoint point) => _layers[point.Layer] || (point.Handle != 0 && _handles.Contains(point.Handle)) || _linetypes[_drawing.LinetypeOf(point)] || _paths[point.BlockPath]
        || (_colours.Count > 0 && _colours.Contains(OperationSelection.NameOf(point.Colour.Resolved(_drawing.Layers[point.Layer].Colour, DrawingColour.Foreground))));

    /// <summary>True for an insert of a named block, not for those nested in it.</summary>
    public bool Has(in PlacedInsert insert) => _blocks[_drawing.BlockPaths[insert.Path].Block];

    /// <summary>True for a curve of a named block, at any depth.</summary>
    public bool IsOfBlock(int entity) => _paths[_drawing.BlockPathOf(entity)];

    /// <summary>True for a point of a named block, at any depth.</summary>
    public bool IsOfBlock(in PlacedPoint point) => _paths[point.BlockPath];
}
