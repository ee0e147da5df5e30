using System.Text;
using Engraver.Core.Drawings;
using Engraver.Core.Sequencing.Ordering;

namespace Engraver.Workbench.Settings;

/// <summary>Every setting between a drawing and its motion, in the order of the help and of the pages. Options are applied in this order. The defaults are
/// those of <see cref="DrawingSettings"/>.</summary>
public static class SettingTable
{
    private const string PlacementCommand = "CNCPLACE";

    public static NamesSetting Layers { get; } = new("layers", s => s.Layers, (s, v) => s with { Layers = v }) { Command = "LAYER", HasOwnCommand = true };

    public static NamesSetting SkippedLayers { get; } = new("skip-layers", s => s.SkippedLayers, (s, v) => s with { SkippedLayers = v ?? [] }) { Command = "LAYER", HasOwnCommand = true };

    public static UnitSetting Units { get; } = new("units", s => s.Unit, (s, v) => s with { Unit = v }) { Command = "CNCUNITS", Page = SettingPage.Drawing };

    public static ScaleSetting Scale { get; } = new("scale", s => s.Placement.Scale, (s, v) => s with { Placement = s.Placement with { Scale = v } })
    {
        Argument = "F", Min = 1e-6, Max = 1e6, Command = PlacementCommand, HasOwnCommand = true,
    };

    public static OptionalChoiceSetting<MirrorAxis> Mirror { get; } = new("mirror", s => s.Placement.Mirror, (s, v) => s with { Placement = s.Placement with { Mirror = v } }) { Command = PlacementCommand, HasOwnCommand = true };

    public static RotationSetting Rotate { get; } = new("rotate", s => s.Placement.Rotation, (s, v) => s with { Placement = s.Placement with { Rotation = v } })
    {
        Unit = "deg", Argument = "DEG", Min = -3600.0, Max = 3600.0, Command = PlacementCommand, HasOwnCommand = true,
    };

    public static OptionalChoiceSetting<BlankPlace> Place { get; } = new("place", s => s.Placement.Place, (s, v) => s with { Placement = s.Placement with { Place = v } }) { Command = PlacementCommand, HasOwnCommand = true };

    public static PointPairSetting Align { get; } = new("align", s => s.Placement.Align, (s, v) => s with { Placement = s.Placement with { Align = v } })
    {
        Unit = "mm", Argument = "X1,Y1:X2,Y2", Command = PlacementCommand, HasOwnCommand = true,
    };

    public static PointPairSetting To { get; } = new("to", s => s.Placement.To, (s, v) => s with { Placement = s.Placement with { To = v } })
    {
        Unit = "mm", Argument = "U1,V1:U2,V2", Command = PlacementCommand, HasOwnCommand = true,
    };

    public static OptionalNumberSetting AlignTolerance { get; } = new("align-tolerance", s => s.Placement.AlignTolerance, (s, v) => s with { Placement = s.Placement with { AlignTolerance = v } })
    {
        Unit = "mm", Argument = "MM", Min = 0.0, Max = 1e3, Command = PlacementCommand, HasOwnCommand = true,
    };

    public static MoveSetting Move { get; } = new("move", s => s.Placement.Move, (s, v) => s with { Placement = s.Placement with { Move = v } }) { Unit = "mm", Command = PlacementCommand, HasOwnCommand = true };

    public static BlankSetting Blank { get; } = new("blank", s => s.Placement.Blank, (s, v) => s with { Placement = s.Placement with { Blank = v } }) { Unit = "mm", Command = PlacementCommand, HasOwnCommand = true };

    public static OptionalChoiceSetting<MirrorAxis> Back { get; } = new("back", s => s.Placement.Back, (s, v) => s with { Placement = s.Placement with { Back = v } }) { Command = PlacementCommand, HasOwnCommand = true };

    public static CutSetting Cut { get; } = new("cut", s => s.Cut, (s, v) => s with { Cut = v }) { Command = "CNCCUT", Page = SettingPage.Drawing };

    public static NumberSetting JoinTolerance { get; } = new("join-tolerance", s => s.JoinToleranceMm, (s, v) => s with { JoinToleranceMm = v })
    {
        Unit = "mm", Argument = "MM", Min = 0.0, Max = 1e3, Command = "CNCJOINTOL", Page = SettingPage.Drawing,
    };

    public static NumberSetting MaxError { get; } = new("max-error", s => s.MaxErrorMm, (s, v) => s with { MaxErrorMm = v })
    {
        Unit = "mm", Argument = "MM", Min = 1e-9, Max = 1e3, Command = "CNCMAXERR", Page = SettingPage.Drawing,
    };

    public static NumberSetting CornerTolerance { get; } = new("corner-tolerance", s => s.CornerToleranceMm, (s, v) => s with { CornerToleranceMm = v })
    {
        Unit = "mm", Argument = "MM", Min = 0.0, Max = 1e3, Command = "CNCCORNER", Page = SettingPage.Toolpath,
    };

    public static SwitchSetting FitArcs { get; } = new("fit-arcs", s => s.FitArcs, (s, v) => s with { FitArcs = v }) { Command = "CNCFITARCS", Page = SettingPage.Toolpath };

    public static PointSetting Start { get; } = new("start", s => s.Start, (s, v) => s with { Start = v }) { Unit = "mm", Command = "TOOLSTART", HasOwnCommand = true };

    public static FinishSetting Finish { get; } = new("finish", s => s.Finish, (s, v) => s with { Finish = v }) { Command = "CNCFINISH", HasOwnCommand = true, Page = SettingPage.Toolpath };

    public static EnteringSetting Enter { get; } = new("enter", s => s.Enter, (s, v) => s with { Enter = v }) { Command = "ENTER", HasOwnCommand = true };

    public static ChoiceSetting<StrokeOrder> Order { get; } = new("order", s => s.Order, (s, v) => s with { Order = v }) { Command = "CNCORDER", Page = SettingPage.Toolpath };

    public static ChoiceSetting<OrderCost> OrderCost { get; } = new("order-cost", s => s.OrderCost, (s, v) => s with { OrderCost = v }) { Command = "CNCORDERCOST", Page = SettingPage.Toolpath };

    public static OptionalNumberSetting OrderSeconds { get; } = new("order-seconds", s => s.OrderSeconds, (s, v) => s with { OrderSeconds = v })
    {
        Unit = "s", Argument = "S", Min = 0.0, Max = 86400.0, Command = "CNCORDERTIME", Page = SettingPage.Toolpath,
    };

    public static SwitchSetting KeepDuplicates { get; } = new("keep-duplicates", s => s.KeepDuplicates, (s, v) => s with { KeepDuplicates = v }) { Command = "CNCDUPLICATES", Page = SettingPage.Drawing };

    public static SwitchSetting RecoverArcs { get; } = new("recover-arcs", s => s.RecoverArcs, (s, v) => s with { RecoverArcs = v }) { Command = "CNCRECOVER", Page = SettingPage.Drawing };

    public static KerfSetting Kerf { get; } = new("kerf", s => s.Kerf, (s, v) => s with { Kerf = v }) { Command = "KERF", HasOwnCommand = true, Page = SettingPage.Toolpath };

    public static ToolDiameterSetting ToolDiameter { get; } = new("tool-diameter", s => s.ToolDiameterMm, (s, v) => s with { ToolDiameterMm = v })
    {
        Unit = "mm", Argument = "MM", Min = 1e-3, Max = 1e3, Command = "KERF", HasOwnCommand = true, Page = SettingPage.Toolpath,
    };

    public static OperationsSetting Operations { get; } = new("operations") { Command = "OPERATION", HasOwnCommand = true };

    public static ToolSetting Tool { get; } = new("tool-number", s => s.Tool, (s, v) => s with { Tool = (int)v }) { Argument = "N", Min = 1, Max = 9999, Whole = true, Command = "OPERATION", HasOwnCommand = true };

    public static MachineSetting Machine { get; } = new("machine") { Command = "CNCPROFILE", HasOwnCommand = true };

    public static FeedSetting Feed { get; } = new("feed", m => m.FeedMmPerMinute, (m, v) => m with { FeedMmPerMinute = v })
    {
        Unit = "mm/min", Argument = "MM/MIN", Min = 1e-6, Max = 1e9, JsonField = "feedMmPerMinute", Command = "CNCFEED", Page = SettingPage.Machine,
    };

    public static MachineNumberSetting VectorSpeed { get; } = new("vector-speed", m => m.Scale.Coarser.CountsOf(m.FeedMmPerMinute / 60.0), (m, v) => m with { FeedMmPerMinute = m.Scale.Coarser.LengthOf(v * 60.0) })
    {
        Unit = "counts/s", HasOption = false, Min = 1e-3, Max = 1e12, Command = "CNCVS", Page = SettingPage.Machine,
    };

    public static MachineNumberSetting Rapid { get; } = new("rapid", m => m.RapidMmPerMinute, (m, v) => m with { RapidMmPerMinute = v })
    {
        Unit = "mm/min", HasOption = false, Min = 1e-6, Max = 1e9, JsonField = "rapidMmPerMinute", Command = "CNCRAPID", Page = SettingPage.Machine,
    };

    public static MachineNumberSetting Acceleration { get; } = new("acceleration", m => m.AccelerationCounts, (m, v) => m with { AccelerationCounts = (int)v })
    {
        Unit = "counts/s2", HasOption = false, Min = 1024, Max = 67107840, Whole = true, JsonField = "accelerationCounts", Command = "CNCVA", Page = SettingPage.Machine,
    };

    public static IReadOnlyList<Setting> All { get; } =
        [Layers, SkippedLayers, Units, Scale, Mirror, Rotate, Place, Align, To, AlignTolerance, Move, Blank, Back, Cut, JoinTolerance, MaxError, CornerTolerance, FitArcs, Start, Finish, Enter, Order, OrderCost, OrderSeconds, KeepDuplicates, RecoverArcs, Kerf, ToolDiameter, Operations, Tool, Machine, Feed, VectorSpeed, Rapid, Acceleration];

    /// <summary>The setting of a key; null when there is none.</summary>
    public static Setting? Find(string key) => All.FirstOrDefault(setting => setting.Key == key);

    /// <summary>The text of docs/settings.md.</summary>
    public static string ToMarkdown()
    {
        var page = new StringBuilder("# Settings\n\nThis page is generated from the program's own table (`./test --update-golden`).\nMessages name a setting by its key in brackets; the console shows its option there, the desktop its command.\n\n");
        page.Append("| Key | Setting | Unit | Default | Option | Command | Range of the command | JSON | Meaning |\n|---|---|---|---|---|---|---|---|---|\n");
        foreach (var setting in All)
        {
            page.Append("| ").AppendJoin(" | ", setting.Key, setting.Name, setting.Unit, setting.Default, Code($"{setting.Option} {(setting.HasOption ? setting.Argument : "")}".Trim()), Code(setting.Command), Range(setting), Code(setting.JsonField), setting.Meaning).Append(" |\n");
        }

        return page.ToString();
    }

    private static string Range(Setting setting) => setting.Max > setting.Min ? $"{TypedNumber.Exact(setting.Min)} to {TypedNumber.Exact(setting.Max)}" : "";

    private static string Code(string? text) => string.IsNullOrEmpty(text) ? "" : $"`{text.Replace("|", "\\|", StringComparison.Ordinal)}`";
}
