using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf.Records;

/// <summary>The layers found so far and their states. A layer that is not defined in a table is on, thawed and plotted.</summary>
internal sealed class LayerTable(NameTable names)
{
    private const int FrozenFlag = 1;
    private const int LockedFlag = 4;
    private readonly List<LayerState> _states = [];

    /// <summary>Number of layer 0. Content of a block on it takes the layer of the insert.</summary>
    public int Zero { get; } = names.IdOf("0");

    /// <summary>Takes a LAYER entry: 70 bit 1 frozen, bit 4 locked; 62 the colour, negative when off; 420 a true colour; 290 zero when not plotted; 370 the
    /// lineweight.</summary>
    public void Define(EntityRecord entry)
    {
        Grow();
        _states[entry.Name] = new LayerState((entry.Flags(70) & FrozenFlag) != 0, (entry.Flags(70) & LockedFlag) != 0, entry.Number(62, 7.0) < 0.0, entry.Number(290, 1.0) == 0.0, entry.Colour, entry.Linetype is Linetype.ByLayer or Linetype.ByBlock ? Linetype.Continuous : entry.Linetype, entry.Lineweight is >= 0 and var weight ? weight : Lineweight.Default);
    }

    public bool IsFrozen(int layer) => layer < _states.Count && _states[layer].Frozen;

    /// <summary>True for a layer that is frozen or switched off.</summary>
    public bool IsHidden(int layer) => layer < _states.Count && (_states[layer].Frozen || _states[layer].Off);

    /// <summary>True for a layer that is visible and plotted.</summary>
    public bool IsCut(int layer) => !IsHidden(layer) && !(layer < _states.Count && _states[layer].NotPlotted);

    /// <summary>Number of its linetype.</summary>
    public int LinetypeOf(int layer) => layer < _states.Count ? _states[layer].Linetype : Linetype.Continuous;

    /// <summary>Its lineweight, hundredths of a millimetre, or the default.</summary>
    public int LineweightOf(int layer) => layer < _states.Count ? _states[layer].Lineweight : Lineweight.Default;

    public DrawingColour ColourOf(int layer) => layer < _states.Count ? _states[layer].Colour.OrForeground() : DrawingColour.Foreground;

    public IReadOnlyList<Layer> ToLayers()
    {
        Grow();
        return [.. _states.Select((state, id) => new Layer(names[id], !state.Off, state.Frozen, !state.NotPlotted) { Colour = state.Colour.OrForeground(), Locked = state.Locked, Linetype = state.Linetype, Lineweight = state.Lineweight })];
    }

    private void Grow()
    {
        while (_states.Count < names.Count) _states.Add(new LayerState { Linetype = Linetype.Continuous, Lineweight = Lineweight.Default });
    }

    private readonly record struct LayerState(bool Frozen, bool Locked, bool Off, bool NotPlotted, DrawingColour Colour, int Linetype, int Lineweight);
}
