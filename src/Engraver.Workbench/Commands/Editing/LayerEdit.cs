using Engraver.Core.Drawings;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>The edited layers while LAYER runs: the document changes only at its end.</summary>
internal sealed class LayerEdit
{
    private const int LongestName = 255;

    /// <summary>Characters that a layer name in DXF must not contain.</summary>
    private const string Forbidden = "<>/\\\":;?*|,=`";

    private readonly List<Layer> _layers;
    private readonly List<(string From, string To)> _renamed = [];

    public LayerEdit(CommandContext context) => (_layers, Current) = ([.. context.Drawing.Layers], NameOf(context));

    public IReadOnlyList<Layer> Layers => _layers;

    /// <summary>Name of the current layer.</summary>
    public string Current { get; private set; }

    /// <summary>Whether a layer has this name, case-insensitive.</summary>
    public static bool Is(Layer layer, string name) => layer.Name.Equals(name, StringComparison.OrdinalIgnoreCase);

    /// <summary>Error message if a layer does not exist; otherwise null.</summary>
    public string? WhyUnknown(IEnumerable<string> names)
    {
        var unknown = names.Where(name => Find(name) is null).ToList();
        return unknown.Count == 0 ? null : Wording.Get("Layer.NotFound", string.Join(", ", unknown.Select(name => $"'{name}'")));
    }

    /// <summary>Why no layer of this name can be created and set: the name is invalid, or the layer is frozen; null if it can.</summary>
    public string? WhyNotMade(string name) => Find(name) is null ? WhyNoName(name) : WhyNotSet(name);

    /// <summary>Why this layer cannot be current: it does not exist or is frozen; null if it can.</summary>
    public string? WhyNotSet(string name) => WhyUnknown([name]) ?? (Named(name) is { Frozen: true } frozen ? Wording.Get("Layer.FrozenNotCurrent", frozen.Name) : null);

    /// <summary>Why this layer cannot be renamed: it does not exist or is layer 0; null if it can.</summary>
    public string? WhyNotRenamed(string name) => WhyUnknown([name]) ?? (Named(name).Name == CurrentLayer.First ? Wording.Get("Layer.NotRenamed", CurrentLayer.First) : null);

    /// <summary>Why this layer cannot get that name: it is invalid or already used; null if it can.</summary>
    public string? WhyNotNamed(string name, string to) => WhyNoName(to) ?? (Find(to) is { } other && other != Find(name) ? Wording.Get("Layer.NameTaken", _layers[other].Name) : null);

    /// <summary>Creates a layer unless it exists and makes it current. Precondition: <see cref="WhyNotMade"/> is null.</summary>
    public void Make(string name)
    {
        if (Find(name) is null) _layers.Add(new Layer(name, On: true, Frozen: false, Plot: true));
        Set(name);
    }

    /// <summary>Sets the current layer. Precondition: <see cref="WhyNotSet"/> is null.</summary>
    public void Set(string name) => Current = Named(name).Name;

    /// <summary>Renames a layer. Precondition: <see cref="WhyNotRenamed"/> and <see cref="WhyNotNamed"/> are null.</summary>
    public void Rename(string name, string to)
    {
        var from = Named(name).Name;
        _layers[Find(name)!.Value] = Named(name) with { Name = to };
        if (Current == from) Current = to;
        _renamed.Add((from, to));
    }

    /// <summary>Changes the matching layers.</summary>
    public void Change(Predicate<Layer> isMeant, Func<Layer, Layer> change)
    {
        for (var index = 0; index < _layers.Count; index++)
        {
            if (isMeant(_layers[index])) _layers[index] = change(_layers[index]);
        }
    }

    /// <summary>Commits one undo step if something has changed. Settings that refer to a renamed layer are updated.</summary>
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
