
namespace Engraver.Workbench.Settings;

/// <summary>What the desktop remembers between two starts. Immutable; the defaults are those of the first start.</summary>
public sealed record DesktopSettings
{
    public const int MaxRecentFiles = 10;

    public static DesktopSettings Default { get; } = new();

    /// <summary>Full paths, the last one opened first.</summary>
    public IReadOnlyList<string> RecentFiles { get; init; } = [];

    /// <summary>The folder that was used last for each kind of file, full paths.</summary>
    public IReadOnlyDictionary<string, string> FileFolders { get; init; } = new Dictionary<string, string>();

    public DesktopTheme Theme { get; init; }

    /// <summary>Code of the language of the desktop (<c>en</c>, <c>de</c>); null: that of the system.</summary>
    public string? Language { get; init; }

    /// <summary>Scale of the whole window, 1 is 100 %.</summary>
    public double Scale { get; init; } = 1.0;

    /// <summary>Device-independent pixels.</summary>
    public double WindowWidth { get; init; } = 1280.0;

    public double WindowHeight { get; init; } = 800.0;

    public bool WindowMaximised { get; init; }

    /// <summary>Sizes of the panels by name, device-independent pixels.</summary>
    public IReadOnlyDictionary<string, double> PanelSizes { get; init; } = new Dictionary<string, double>();

    /// <summary>Names of the panels that are folded.</summary>
    public IReadOnlyList<string> FoldedPanels { get; init; } = [];

    /// <summary>Names of the panels that the operator has opened in a window so small that they are folded there.</summary>
    public IReadOnlyList<string> PanelsOpenWhenSmall { get; init; } = [];

    /// <summary>File of the machine profile that was taken last; null: the built-in one.</summary>
    public string? LastProfile { get; init; }

    /// <summary>Address of the controller that was connected last.</summary>
    public string? LastAddress { get; init; }

    /// <summary>System variables by name; one that is missing has its first value.</summary>
    public IReadOnlyDictionary<string, double> Variables { get; init; } = new Dictionary<string, double>();

    /// <summary>The view that each recent file was left with.</summary>
    public IReadOnlyDictionary<string, SavedView> Views { get; init; } = new Dictionary<string, SavedView>();

    /// <summary>These settings with a file at the head of the recent ones; views of files that drop out of the list are forgotten.</summary>
    public DesktopSettings WithRecent(string path)
    {
        var recent = RecentFiles.Where(file => file != path).Prepend(path).Take(MaxRecentFiles).ToList();
        return this with { RecentFiles = recent, Views = Views.Where(view => recent.Contains(view.Key)).ToDictionary() };
    }

    /// <summary>These settings without a file that is gone.</summary>
    public DesktopSettings WithoutRecent(string path) => this with { RecentFiles = [.. RecentFiles.Where(file => file != path)], Views = Views.Where(view => view.Key != path).ToDictionary() };

    public DesktopSettings WithFileFolder(string kind, string folder) => FileFolders.GetValueOrDefault(kind) == folder ? this : this with { FileFolders = new Dictionary<string, string>(FileFolders) { [kind] = folder } };

    public DesktopSettings WithVariable(string name, double value) => this with { Variables = new Dictionary<string, double>(Variables) { [name] = value } };

    public DesktopSettings WithPanelSize(string panel, double size) => this with { PanelSizes = new Dictionary<string, double>(PanelSizes) { [panel] = size } };

    public DesktopSettings WithPanelFolded(string panel, bool folded) => this with { FoldedPanels = With(FoldedPanels, panel, folded) };

    public DesktopSettings WithPanelOpenWhenSmall(string panel, bool open) => this with { PanelsOpenWhenSmall = With(PanelsOpenWhenSmall, panel, open) };

    public DesktopSettings WithView(string path, SavedView view) => this with { Views = new Dictionary<string, SavedView>(Views) { [path] = view } };

    private static IReadOnlyList<string> With(IReadOnlyList<string> names, string name, bool isThere) => isThere ? [.. names.Where(other => other != name), name] : [.. names.Where(other => other != name)];
}
