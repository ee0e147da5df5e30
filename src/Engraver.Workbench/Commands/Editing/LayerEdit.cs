using Engraver.Core.Drawings;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>The layers while LAYER asks for more: nothing of the document changes before its end.</summary>
internal sealed class LayerEdit
{
    private const int LongestName = 255;

    /// <summary>Letters that no layer of a DXF has in its name.</summary>
    private const string Forbidden = "<>/\\\":;?*|,=`";

    private readonly List<Layer> _layers;
    private readonly List<(string From, string To)> _renamed = [];

    public LayerEdit(CommandContext context) => (_layers, Current) = ([.. context.Drawing.Layers], NameOf(context));

    public IReadOnlyList<Layer> Layers => _layers;

    /// <summary>Name of the current layer.</summary>
    public string Current { get; private set; }

    /// <summary>Whether a layer has this name; capitals and small letters are the same.</summary>
    public static bool Is(Layer layer, string name) => layer.Name.Equals(name, StringComparison.OrdinalIgnoreCase);

    /// <summary>Says that there are no such layers; null where there are.</summary>
    public string? WhyUnknown(IEnumerable<string> names)
    {
        var unknown = names.Where(name => Find(name) is null).ToList();
        return unknown.Count == 0 ? null : Wording.Get("Layer.NotFound", string.Join(", ", unknown.Select(name => $"'{name}'")));
    }

    /// <summary>Says why no layer of this name can be made and set: the name is not allowed, or there is one that is frozen; null where it can.</summary>
    public string? WhyNotMade(string name) => Find(name) is null ? WhyNoName(name) : WhyNotSet(name);

    /// <summary>Says why this layer cannot be the current one: there is none, or it is frozen; null where it can.</summary>
    public string? WhyNotSet(string name) => WhyUnknown([name]) ?? (Named(name) is { Frozen: true } frozen ? Wording.Get("Layer.FrozenNotCurrent", frozen.Name) : null);

    /// <summary>Says why this layer keeps its name: there is none, or it is layer 0; null where it can have another.</summary>
    public string? WhyNotRenamed(string name) => WhyUnknown([name]) ?? (Named(name).Name == CurrentLayer.First ? Wording.Get("Layer.NotRenamed", CurrentLayer.First) : null);

    /// <summary>Says why this layer cannot have that name: it is not allowed, or another has it; null where it can.</summary>
    public string? WhyNotNamed(string name, string to) => WhyNoName(to) ?? (Find(to) is { } other && other != Find(name) ? Wording.Get("Layer.NameTaken", _layers[other].Name) : null);

    /// <summary>Makes a layer, where there is none of this name, and sets it. Nothing speaks against it (<see cref="WhyNotMade"/>).</summary>
    public void Make(string name)
    {
        if (Find(name) is null) _layers.Add(new Layer(name, On: true, Frozen: false, Plot: true));
        Set(name);
    }

    /// <summary>Sets the current layer. Nothing speaks against it (<see cref="WhyNotSet"/>).</summary>
    public void Set(string name) => Current = Named(name).Name;

    /// <summary>Gives a layer another name. Nothing speaks against it (<see cref="WhyNotRenamed"/>, <see cref="WhyNotNamed"/>).</summary>
    public void Rename(string name, string to)
    {
        var from = Named(name).Name;
        _layers[Find(name)!.Value] = Named(name) with { Name = to };
        if (Current == from) Current = to;
        _renamed.Add((from, to));
    }

    /// <summary>Changes the layers that are meant.</summary>
    public void Change(Predicate<Layer> isMeant, Func<Layer, Layer> change)
    {
        for (var index = 0; index < _layers.Count; index++)
        {
            if (isMeant(_layers[index])) _layers[index] = change(_layers[index]);
        }
    }

    /// <summary>One document step, where something has changed. Settings that name a renamed layer name it anew.</summary>
    public void Take(CommandContext context)
    {
        var state = context.Document.Current;
        if (Layers.SequenceEqual(context.Drawing.Layers) && Current == NameOf(context)) return;
        var settings = state.Settings;
        if (_renamed.Count > 0) settings = settings with { Layers = settings.Layers is { } chosen ? Renamed(chosen) : null, SkippedLayers = Renamed(settings.SkippedLayers) };
        context.Take(state with { Drawing = Layers.SequenceEqual(context.Drawing.Layers) ? state.Drawing : context.Drawing with { Layers = [.. Layers] }, Settings = settings, CurrentLayer = Current });
    }

    private static string NameOf(CommandContext context) => CurrentLayer.IndexOf(context.Drawing, context.Document.Current.CurrentLayer) is { } index ? context.Drawing.Layers[index].Name : context.Document.Current.CurrentLayer;

    private static string? WhyNoName(string name) => name.Length is 0 or > LongestName || name.Any(Forbidden.Contains) ? Wording.Get("Layer.InvalidName", name, Forbidden) : null;

    private int? Find(string name) => _layers.FindIndex(layer => Is(layer, name)) is >= 0 and var index ? index : null;

    private Layer Named(string name) => _layers[Find(name)!.Value];

    private IReadOnlyList<string> Renamed(IReadOnlyList<string> names) =>
        [.. names.Select(name => _renamed.Aggregate(name, (now, change) => now.Equals(change.From, StringComparison.OrdinalIgnoreCase) ? change.To : now))];
}
