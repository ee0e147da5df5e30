using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Cli.Options;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Verbs.Hand;

/// <summary><c>engraver zero</c> sets a work origin at the machine's position: as its zero, a point of the drawing, a touched edge or the centre of two
/// touches; <c>engraver origin</c> chooses one.</summary>
internal sealed class OriginVerbs
{
    private const double MaxRadiusMm = 100.0;

    private readonly VerbHost _host;
    private readonly MachineAction _action;

    private OriginVerbs(VerbHost host) => (_host, _action) = (host, new MachineAction(host));

    public static Command Zero(VerbHost host)
    {
        var verb = new OriginVerbs(host);
        var options = new ZeroOptions();
        var command = verb._action.Command("zero", Wording.Get("Hand.Zero"));
        options.AddTo(command);
        command.SetAction((parsed, stop) => verb._action.RunAsync(parsed, (machine, cancellation) => verb.ZeroAsync(machine, options, parsed, cancellation), stop));
        return command;
    }

    public static Command Origin(VerbHost host)
    {
        var verb = new OriginVerbs(host);
        var name = new Argument<string?>("NAME") { Arity = ArgumentArity.ZeroOrOne, Description = Wording.Get("Hand.OriginName") };
        name.Validators.Add(ZeroOptions.CheckName);
        var at = new Option<string?>("--at") { HelpName = "X,Y[,Z]", Description = Wording.Get("Hand.OriginAt") };
        at.Validators.Add(result =>
        {
            if (result.Tokens is [var token] && MachinePlaceOf(token.Value) is null) result.AddError(Wording.Get("Hand.InvalidMachinePosition", token.Value));
        });
        var command = verb._action.Command("origin", Wording.Get("Hand.Origin"));
        command.Arguments.Add(name);
        command.Options.Add(at);
        command.SetAction((parsed, stop) => verb._action.RunAsync(
            parsed,
            (machine, cancellation) => parsed.GetValue(at) is { } typed ? verb.TypeAsync(machine, parsed.GetValue(name), MachinePlaceOf(typed)!, cancellation) : Task.FromResult(verb.Choose(machine, parsed.GetValue(name))),
            stop));
        return command;
    }

    private int Choose(MachineSession machine, string? name) =>
        name is not null && machine.Origins.Choose(WorkOriginNames.Find(name)!) is { } failure ? _action.NotMoved(failure) : ExitCode.Done;

    private static TypedMachinePosition? MachinePlaceOf(string typed) => new MachinePositionPrompt("") { AllowsZ = true }.Parse(typed, default) is ParsedInput<TypedMachinePosition>.Value { Result: var place } ? place : null;

    private async Task<int> TypeAsync(MachineSession machine, string? name, TypedMachinePosition place, CancellationToken stop)
    {
        var axes = machine.Profile.Axes;
        if (place.Z is not null && axes.Z is null) return _action.NotMoved(Wording.Get("Hand.NoZAxis"));
        if (!place.FitsCounter(axes.Scale)) return _action.NotMoved(Wording.Get("Hand.BeyondCounterRange"));
        var chosen = name is null ? machine.Connection.Lease!.Memory.Active : WorkOriginNames.Find(name)!;
        return await machine.Origins.TypeAsync(chosen, place.ToCounts(axes.Scale), withHeight: place.Z is not null, stop).ConfigureAwait(false) is { } refusal ? NotSet(refusal) : ExitCode.Done;
    }

    private async Task<int> ZeroAsync(MachineSession machine, ZeroOptions options, ParseResult parsed, CancellationToken stop)
    {
        var (profile, (touch, name, z)) = (machine.Profile, options.Read(parsed, machine.Profile.Scale));
        if (z && profile.Axes.Z is null) return _action.NotMoved(Wording.Get("Hand.NoZAxis"));
        if (touch is null || !touch.IsCountable(profile.Scale)) return _action.NotMoved(Wording.Get("Hand.BeyondCounterRange"));
        var refused = await machine.Origins.SetAsync((memory, here) => touch.Set(memory with { Active = name ?? memory.Active }, name ?? memory.Active, here.Position, profile), stop).ConfigureAwait(false);
        return refused is { } refusal ? NotSet(refusal) : ExitCode.Done;
    }

    private int NotSet(Diagnostic refusal)
    {
        _host.Error.WriteLine(Wording.Get("Hand.OriginNotSet", SettingWording.OnConsole(refusal).Message));
        return ExitCode.DrawingError;
    }

    private sealed class ZeroOptions
    {
        private readonly Option<bool> _x = new("--x") { Description = Wording.Get("Hand.ZeroX") };
        private readonly Option<bool> _y = new("--y") { Description = Wording.Get("Hand.ZeroY") };
        private readonly Option<bool> _z = new("--z") { Description = Wording.Get("Hand.ZeroZ") };
        private readonly Option<string?> _point = PlaceOption("--point", Wording.Get("Hand.ZeroPoint"));
        private readonly Option<string?> _edge = new("--edge") { HelpName = "left|bottom|right|top", Description = Wording.Get("Hand.ZeroEdge") };
        private readonly Option<double> _radius = new("--radius") { HelpName = "MM", Description = Wording.Get("Hand.ZeroRadius"), CustomParser = ParseRadius };
        private readonly Option<string?> _centre = PlaceOption("--centre", Wording.Get("Hand.ZeroCentre"));
        private readonly Option<double?> _height = new("--height") { HelpName = "MM", Description = Wording.Get("Hand.ZeroHeight"), CustomParser = result => OptionValue.AnyNumber(result) };
        private readonly Option<string?> _name = new("--origin") { HelpName = "G54", Description = Wording.Get("Hand.ZeroOrigin") };

        public ZeroOptions()
        {
            _edge.AcceptOnlyFromAmong([.. Enum.GetNames<WorkEdge>().Select(edge => edge.ToLowerInvariant())]);
            _name.Validators.Add(CheckName);
        }

        public void AddTo(Command command)
        {
            foreach (var option in (Option[])[_x, _y, _z, _point, _edge, _radius, _centre, _height, _name]) command.Options.Add(option);
            command.Validators.Add(result =>
            {
                bool Has(Option option) => result.GetResult(option) is { Implicit: false };
                if (new Option[] { _point, _edge, _centre }.Count(Has) > 1 || ((Has(_z) || Has(_height)) && (Has(_edge) || Has(_centre))) || (Has(_edge) && (Has(_x) || Has(_y)))) result.AddError(Wording.Get("Hand.ZeroOneWay"));
                if (Has(_radius) && !Has(_edge)) result.AddError(Wording.Get("Hand.ZeroRadiusOfEdge"));
            });
        }

        /// <returns>How the position is used, null if its first touch exceeds the counter range; the origin's name, null for the active one; whether the height
        /// was requested.</returns>
        public (ZeroTouch? Touch, string? Name, bool AsksHeight) Read(ParseResult parsed, CountsScale scale)
        {
            var (x, y, z) = (parsed.GetValue(_x), parsed.GetValue(_y), parsed.GetValue(_z) || parsed.GetValue(_height) is not null);
            var (point, centre) = (Place(parsed.GetValue(_point)), Place(parsed.GetValue(_centre)));
            var all = !x && !y && (!z || point is not null);
            WorkEdge? edge = parsed.GetValue(_edge) is { } named ? Enum.Parse<WorkEdge>(named, ignoreCase: true) : null;
            var isWhole = all && point is null && edge is null && centre is null; // No axis is named and the zero is here: the height is set too if there is a Z axis.
            var first = centre is { } touched ? HandTarget.OfMachine(touched, scale) : null;
            var touch = new ZeroTouch { X = all || x, Y = all || y, Z = z || isWhole, Place = point ?? default, Height = parsed.GetValue(_height) ?? 0.0, Edge = edge, Radius = parsed.GetValue(_radius), First = first };
            return (centre is not null && first is null ? null : touch, parsed.GetValue(_name) is { } given ? WorkOriginNames.Find(given) : null, z);
        }

        /// <summary>Rejects a text that is not the name of a work origin.</summary>
        public static void CheckName(SymbolResult result)
        {
            if (result.Tokens is [var token] && WorkOriginNames.Find(token.Value) is null) result.AddError(Wording.Get("Hand.InvalidOrigin", token.Value, string.Join(", ", WorkOriginNames.All)));
        }

        private static Point2D? Place(string? typed) => typed is null ? null : PlacementOptions.TryParsePosition(typed);

        private static Option<string?> PlaceOption(string name, string description)
        {
            var option = new Option<string?>(name) { HelpName = "X,Y", Description = description };
            option.Validators.Add(result =>
            {
                if (result.Tokens is [var token] && PlacementOptions.TryParsePosition(token.Value) is null) result.AddError(Wording.Get("Hand.InvalidPosition", token.Value));
            });
            return option;
        }

        private static double ParseRadius(ArgumentResult result)
        {
            if (NumberPrompt.TryParse(result.Tokens[0].Value, out var radius) && radius is >= 0.0 and <= MaxRadiusMm) return radius;
            result.AddError(Wording.Get("Hand.InvalidRadius", result.Tokens[0].Value, MaxRadiusMm));
            return 0.0;
        }
    }
}
