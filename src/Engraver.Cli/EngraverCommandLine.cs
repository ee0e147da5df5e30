using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Cli.Verbs;
using Engraver.Cli.Verbs.Hand;
using Engraver.Cli.Verbs.Jobs;
using Engraver.Cli.Verbs.Plates;
using Engraver.Cli.Verbs.Profiles;
using Engraver.Cli.Verbs.Sending;

namespace Engraver.Cli;

/// <summary>Builds the verbs and options of the runner. An unknown verb is a usage error.</summary>
internal static class EngraverCommandLine
{
    public static RootCommand Build(ConsoleStreams streams, GlobalOptions global, ConnectionGuard machine)
    {
        var root = new RootCommand(Wording.Get("EngraverCommandLine.Summary"));
        global.AddTo(root);
        var host = new VerbHost(streams, global, machine);
        root.Subcommands.Add(InfoVerb.Build(host));
        root.Subcommands.Add(MinimiseVerb.Build(host));
        root.Subcommands.Add(TableVerb.Build(host));
        root.Subcommands.Add(SequenceVerb.Build(host));
        root.Subcommands.Add(OffsetVerb.Build(host));
        root.Subcommands.Add(PocketVerb.Build(host));
        root.Subcommands.Add(TrajectoryVerb.Build(host));
        root.Subcommands.Add(PlotVerb.Build(host));
        root.Subcommands.Add(PlanVerb.Build(host));
        root.Subcommands.Add(PostVerb.Build(host));
        root.Subcommands.Add(VerifyVerb.Build(host));
        root.Subcommands.Add(CertifyVerb.Build(host));
        root.Subcommands.Add(SendVerb.Build(host));
        root.Subcommands.Add(ReceiveVerb.Build(host));
        root.Subcommands.Add(RunVerb.Build(host));
        root.Subcommands.Add(ReportVerb.Build(host));
        root.Subcommands.Add(HistoryVerb.Build(host));
        root.Subcommands.Add(ReplayVerb.Build(host));
        root.Subcommands.Add(CountersVerb.Build(host));
        root.Subcommands.Add(HandVerbs.Status(host));
        root.Subcommands.Add(HandVerbs.GoTo(host));
        root.Subcommands.Add(JogVerb.Build(host));
        root.Subcommands.Add(HandVerbs.Home(host));
        root.Subcommands.Add(OriginVerbs.Zero(host));
        root.Subcommands.Add(OriginVerbs.Origin(host));
        root.Subcommands.Add(HandVerbs.Motors(host));
        root.Subcommands.Add(FrameVerb.Build(host));
        root.Subcommands.Add(ProfileVerb.Build(host));
        root.Subcommands.Add(DiscoverVerb.Build(host));
        root.Subcommands.Add(CommissionVerb.Build(host));
        root.Subcommands.Add(TerminalVerb.Build(host));
        root.Subcommands.Add(SimulateVerb.Build(host));
        root.Subcommands.Add(BenchVerb.Build(host));
        root.Subcommands.Add(ScriptVerb.Build(host));
        root.Subcommands.Add(DesktopVerb.Build());
        return root;
    }
}
