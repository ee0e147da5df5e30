using System.Globalization;
using System.Text;

namespace Engraver.Workbench.Settings;

/// <summary>Every setting between a drawing and its motion.</summary>
public static class SettingTable
{
    private static readonly DrawingSettings s_defaults = new();

    public static SettingDescription Layers { get; } = new("layers", "Layers", "Cut only these layers, even when they are off (default: visible, not frozen, plottable).")
    {
        Flag = "--layers", Argument = "A,B", Command = "LAYER", Default = "visible, not frozen, plottable",
    };

    public static SettingDescription SkippedLayers { get; } = new("skip-layers", "Layers left out", "Leave these layers out.") { Flag = "--skip-layers", Argument = "A,B", Command = "LAYER", Default = "none" };

    public static SettingDescription Units { get; } = new("units", "Unit of the drawing", "Unit of the drawing, whatever it says itself.")
    {
        CommandHelp = "Unit for the next OPEN as a code of $INSUNITS (1 inch, 4 mm ...); 0: what the drawing says.",
        Flag = "--units", Argument = "mm|inch|auto", Command = "CNCUNITS", Least = 0, Most = 24, Whole = true, Default = "what the drawing says",
    };

    public static SettingDescription Cut { get; } = new("cut", "Construction to be cut", "Construction that is to be cut all the same (default: none).")
    {
        CommandHelp = "Construction that the next OPEN takes for curves: 1 hatch boundaries, 2 multilines, 4 leaders, 8 helices, 16 edges of solids, added together.",
        Flag = "--cut", Argument = "hatch,mline,leader,helix,solid", Command = "CNCCUT", Least = 0, Most = 31, Whole = true, Default = "none",
    };

    public static SettingDescription JoinTolerance { get; } = new("join-tolerance", "Join tolerance", "Ends this close are one point.")
    {
        CommandHelp = "Ends this close are one point, mm.",
        Unit = "mm", Flag = "--join-tolerance", Argument = "MM", Command = "CNCJOINTOL", Least = 0.0, Most = 1e3, Default = Number(s_defaults.JoinToleranceMm),
    };

    public static SettingDescription MaxError { get; } = new("max-error", "Curve error", "How far a chord may stand off its curve.")
    {
        CommandHelp = "How far a chord may stand off its curve, mm.",
        Unit = "mm", Flag = "--max-error", Argument = "MM", Command = "CNCMAXERR", Least = 1e-9, Most = 1e3, Default = Number(s_defaults.MaxErrorMm),
    };

    public static SettingDescription Start { get; } = new("start", "Tool start", "Drawing point where the tool stands (default 0,0).") { Unit = "mm", Flag = "--start", Argument = "X,Y", Command = "TOOLSTART", Default = "0,0" };

    public static SettingDescription Enter { get; } = new("enter", "Entering entity", "Entity or point where cutting begins.") { Flag = "--enter", Argument = "HANDLE|X,Y", Command = "ENTER", Default = "free choice" };

    public static SettingDescription Order { get; } = new("order", "Order of strokes", "Order of the strokes; an inner contour always comes before the one around it.")
    {
        Flag = "--order", Argument = "drawn|nearest", Command = "CNCORDER", Default = "nearest",
    };

    public static SettingDescription KeepDuplicates { get; } = new("keep-duplicates", "Duplicates", "Cut lines that were drawn twice twice.")
    {
        CommandHelp = "1: lines that were drawn twice are cut twice.",
        Flag = "--keep-duplicates", Command = "CNCDUPLICATES", Least = 0, Most = 1, Whole = true, Default = "0",
    };

    public static SettingDescription RecoverArcs { get; } = new("recover-arcs", "Arc recovery", "Cut lines that approximate an arc within [max-error] as that arc.")
    {
        CommandHelp = "1: lines that approximate an arc within CNCMAXERR are cut as that arc.",
        Flag = "--recover-arcs", Command = "CNCRECOVER", Least = 0, Most = 1, Whole = true, Default = "0",
    };

    public static SettingDescription Machine { get; } = new("machine", "Machine profile", "Machine profile (default: the built-in one).") { Flag = "--machine", Argument = "PROFILE.json", Command = "CNCPROFILE", Default = "built in" };

    public static SettingDescription Feed { get; } = new("feed", "Feed", "Cutting speed, instead of the profile's.")
    {
        CommandHelp = "Cutting speed along the path, mm/min.",
        Unit = "mm/min", Flag = "--feed", Argument = "MM/MIN", Command = "CNCFEED", Least = 1e-6, Most = 1e9, JsonField = "feedMmPerMinute", Default = Number(s_defaults.Machine.FeedMmPerMinute),
    };

    public static SettingDescription VectorSpeed { get; } = new("vector-speed", "Vector speed", "The feed in the controller's words.") {  CommandHelp = "Vector speed, counts/s: the feed in the controller's words.", Unit = "counts/s", Command = "CNCVS", Least = 1e-3, Most = 1e12, Default = "from the feed" };

    public static SettingDescription Rapid { get; } = new("rapid", "Rapid speed", "Speed of each axis between strokes.")
    {
        CommandHelp = "Speed of each axis between strokes, mm/min.",
        Unit = "mm/min", Command = "CNCRAPID", Least = 1e-6, Most = 1e9, JsonField = "rapidMmPerMinute", Default = Number(s_defaults.Machine.RapidMmPerMinute),
    };

    public static SettingDescription Acceleration { get; } = new("acceleration", "Acceleration", "Acceleration and deceleration, in steps of 1024.")
    {
        CommandHelp = "Acceleration and deceleration, counts/s2 in steps of 1024.",
        Unit = "counts/s2", Command = "CNCVA", Least = 1024, Most = 67107840, Whole = true, JsonField = "accelerationCounts", Default = Number(s_defaults.Machine.AccelerationCounts),
    };

    public static IReadOnlyList<SettingDescription> All { get; } =
        [Layers, SkippedLayers, Units, Cut, JoinTolerance, MaxError, Start, Enter, Order, KeepDuplicates, RecoverArcs, Machine, Feed, VectorSpeed, Rapid, Acceleration];

    /// <summary>docs/settings.md.</summary>
    public static string ToMarkdown()
    {
        var page = new StringBuilder("# Settings\n\nWritten from the program's own table; `./test --update-golden` writes it anew. Findings name a setting in brackets by its key, and the console or the desktop puts its option or command there.\n\n");
        page.Append("| Key | Setting | Unit | Default | Option | Command | Range of the command | JSON | Meaning |\n|---|---|---|---|---|---|---|---|---|\n");
        foreach (var setting in All)
        {
            page.Append("| ").AppendJoin(" | ", setting.Key, setting.Name, setting.Unit, setting.Default, Code(Option(setting)), Code(setting.Command), Range(setting), Code(setting.JsonField), setting.Help).Append(" |\n");
        }

        return page.ToString();
    }

    private static string Option(SettingDescription setting) => setting.Argument is { } argument ? $"{setting.Flag} {argument}".Trim() : setting.Flag ?? "";

    private static string Range(SettingDescription setting) => setting.Most > setting.Least ? $"{Number(setting.Least)} to {Number(setting.Most)}" : "";

    private static string Code(string? text) => string.IsNullOrEmpty(text) ? "" : $"`{text.Replace("|", "\\|", StringComparison.Ordinal)}`";

    private static string Number(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
