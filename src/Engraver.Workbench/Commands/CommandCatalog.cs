using Engraver.Workbench.Commands.Commissioning;
using Engraver.Workbench.Commands.Drafting;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Commands.Files;
using Engraver.Workbench.Commands.Grips;
using Engraver.Workbench.Commands.Inquiry;
using Engraver.Workbench.Commands.Machine;
using Engraver.Workbench.Commands.Properties;
using Engraver.Workbench.Commands.Reshaping;
using Engraver.Workbench.Commands.Sequencing;
using Engraver.Workbench.Commands.Session;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Commands.Texts;
using Engraver.Workbench.Commands.Toolpaths;
using Engraver.Workbench.Commands.Trajectories;
using Engraver.Workbench.Commands.View;

namespace Engraver.Workbench.Commands;

/// <summary>The commands of this program, by name.</summary>
public sealed class CommandCatalog
{
    private readonly Dictionary<string, ICommand> _commands;

    public CommandCatalog(IEnumerable<ICommand> commands) => _commands = commands.ToDictionary(command => command.Info.Name, StringComparer.OrdinalIgnoreCase);

    /// <summary>By group, then by name.</summary>
    public IEnumerable<CommandInfo> All => _commands.Values.Select(command => command.Info).OrderBy(info => info.Group).ThenBy(info => info.Name, StringComparer.Ordinal);

    /// <summary>The command with this full name, case-insensitive; null when there is none.</summary>
    public ICommand? Find(string name) => _commands.GetValueOrDefault(name);

    /// <summary>All commands of the program.</summary>
    public static CommandCatalog Built() => new(
    [
        new NewCommand(), new OpenCommand(), new RecentCommand(), new HistoryCommand(), new CloseCommand(), new SaveAsCommand(), new QSaveCommand(), new ExportCommand(), new OptionsCommand(), new ScriptCommand(), new UndoCommand(), new UCommand(), new RedoCommand(), new HelpCommand(), new ReinitCommand(), new QuitCommand(),
        new ZoomCommand(), new PanCommand(), new RegenCommand(), new OsnapCommand(), new ThemeCommand(), new LanguageCommand(), new ShowCommand(), new PlaybackCommand(), .. SwitchCommand.All, .. SpacingCommand.All,
        new SelectCommand(), new ListCommand(), new PropertiesCommand(), new DistCommand(), new IdCommand(), new AreaCommand(), new LayerCommand(), new CheckCommand(), new TableCommand(),
        new LineCommand(), new PolylineCommand(), new CircleCommand(), new ArcCommand(), new RectangleCommand(), new PolygonCommand(), new EllipseCommand(),
        new TextCommand(), new MTextCommand(), new TextEditCommand(), new StyleCommand(), new TextExplodeCommand(), new CncTextCommand(),
        new EraseCommand(), new MoveCommand(), new CopyCommand(), new GripEditCommand(), new ChPropCommand(), new RotateCommand(), new ScaleCommand(), new MirrorCommand(), new OffsetCommand(), new ReverseCommand(), new ArrayCommand(), new ExplodeCommand(), new JoinCommand(), new OverkillCommand(),
        .. TrimCommand.All, .. FilletCommand.All, new BreakCommand(), new StretchCommand(), new MatchPropertiesCommand(),
        new PocketCommand(), new OperationCommand(), new OriginCommand(), new HideObjectsCommand(), new UnisolateObjectsCommand(),
        new EnterCommand(), new AutoSequenceCommand(), new ToolStartCommand(), new DiscontinuitiesCommand(),
        new SacePathCommand(), new SaceOffsetCommand(), new SaceUniformOffsetCommand(), new SaceConstantOffsetsCommand(), new SaceDeepEngravingCommand(), new SaceHelicalDrillCommand(), .. SaceLengthCommand.All, new SaceToggleDensityCommand(), new SaceCornersCommand(),
        new SaceShowTrajectoriesCommand(), new SaceEditTrajectoryCommand(), new SaceDeleteLastTrajectoryCommand(), new SaceDeleteAllTrajectoriesCommand(), new SaceUpdateTrajectoriesCommand(), new SaceExportTrajectoriesCommand(), new SaceSimulateCommand(),
        new PostCommand(), new AgiePostCommand(), new LinkCommand(), new VerifyCommand(), new CertifyCommand(), new SendCommand(), new PlotCommand(), new PlotExportCommand(), new ReportCommand(),
        new CncConnectCommand(), new CncDisconnectCommand(), new CncMotorsCommand(), new CncStatusCommand(), new CncProfileCommand(), new CncCommissionCommand(), new CncOutputCommand(),
        new CncHomeCommand(), new CncJogCommand(), new CncGoToCommand(), new CncFrameCommand(), new CncZeroCommand(), new CncOriginCommand(), new CncFinishCommand(), new CncPlateCommand(),
        new CncSimCommand(), new CncArmCommand(), new CncRunCommand(), new CncHoldCommand(), new CncResumeCommand(), new CncContinueCommand(), new CncOverrideCommand(), new CncStopCommand(), new CncAbortCommand(),
        new CncTraceCommand(), new PlotCompareCommand(), new AlarmsCommand(), new CncTerminalCommand(),
        .. SettingCommand.All, new KerfCommand(), new CncPlaceCommand(), new CurrentLayerCommand(), .. SystemVariableCommand.All,
    ]);
}
