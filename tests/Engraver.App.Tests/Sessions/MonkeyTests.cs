using System.Globalization;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Engraver.App.Tests.Start;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.Sessions;

/// <summary>Random input to the desktop: commands, answers, clicks, drags, wheels, keys and drops. The window stays open, there are no internal errors,
/// memory does not grow, files are unchanged, and the stop still works.</summary>
[Collection(DesktopCollection.Name)]
public sealed class MonkeyTests(DesktopFixture fixture)
{
    private const int Seeds = 2;
    private const long MaxMemory = 500L << 20;

    /// <summary>Of the top of the window with the menu titles, which lead to Exit and Save.</summary>
    private const double MenuHeight = 34.0;

    /// <summary>Commands that write files, wait for another computer or move for as long as a job takes.</summary>
    private static readonly string[] s_left =
        ["QSAVE", "SAVEAS", "EXPORT", "POST", "AGIEPOST", "PLOT", "REPORT", "TABLE", "LINK", "CERTIFY", "SEND", "SACEEXPORTTRAJECTORIES", "SCRIPT", "HISTORY", "CNCCOMMISSION", "CNCRUN", "CNCRESUME", "CNCCONTINUE", "SACESIMULATE", "FILEDIA", "RECENT", "OPEN"];

    private static readonly string[] s_answers =
        ["", "", "", "ALL", "L", "P", "W", "C", "R", "A", "U", "0,0", "10,10", "@3,4", "10<45", "50,-20", "1e99,0", "0.5", "2", "-1", "1e300", "nan", "Yes", "No", "ON", "OFF", "sim:", "sim:?speed=max", "*", "A1", "_Close", "'ZOOM", "'", "%s{0}", "gasket.dxf", "no such file.dxf"];

    private static readonly Key[] s_keys =
        [Key.Escape, Key.Escape, Key.Enter, Key.Space, Key.Tab, Key.Delete, Key.Back, Key.Up, Key.Down, Key.Left, Key.Right, Key.PageUp, Key.Home, Key.F1, Key.F2, Key.F3, Key.F7, Key.F8, Key.F9, Key.F10, Key.F12, Key.Pause];

    public static TheoryData<int> SeedsOfThisRun => [.. Enumerable.Range(1, Seeds)];

    [Theory]
    [MemberData(nameof(SeedsOfThisRun))]
    public async Task Whatever_is_done_the_window_lives_and_STOP_answers(int seed)
    {
        using var folder = new TemporaryDesktopFolder();
        foreach (var sample in Directory.GetFiles(RepositoryFolder.Samples, "*.dxf")) File.Copy(sample, Path.Combine(folder.Path, Path.GetFileName(sample)));
        var before = Prints();
        await fixture.WithOperator(here => Play(here, new Random(seed), TestExtent.Cases(250, 10_000, "ENGRAVER_MONKEY_EVENTS")), workFolder: folder.Path);
        Assert.Equal(before, Prints());
    }

    private static void Play(Operator here, Random random, int events)
    {
        var names = CommandCatalog.Built().All.Select(info => info.Name).Except(s_left).ToArray();
        here.Enter("FILEDIA", "0");
        here.Window.Closing += Stay;
        try
        {
            for (var i = 0; i < events; i++)
            {
                Act(here, random, names);
                here.Step();
                if (i % 25 == 24) Calm(here);
            }

            Calm(here);
        }
        finally
        {
            here.Window.Closing -= Stay;
        }

        var failures = Directory.GetFiles(here.Session.FailureReports.Folder, "crash-*.txt").Select(File.ReadAllText);
        Assert.True(!failures.Any(), string.Join('\n', failures));
        Assert.True(here.Window.IsVisible);
        Assert.InRange(GC.GetTotalMemory(forceFullCollection: true), 0, MaxMemory);
        AssertStopAnswers(here);
    }

    private static void Stay(object? sender, WindowClosingEventArgs closing) => closing.Cancel = true;

    private static void Act(Operator here, Random random, string[] names)
    {
        switch (random.Next(10))
        {
            case 0 or 1:
                Say(here, names[random.Next(names.Length)]);
                break;
            case 2 or 3 or 4:
                Say(here, s_answers[random.Next(s_answers.Length)]);
                break;
            case 5:
                here.Hands.Click(Place(here, random), random.Next(5) == 0 ? MouseButton.Right : MouseButton.Left, random.Next(4) == 0 ? RawInputModifiers.Shift : RawInputModifiers.None);
                break;
            case 6:
                here.Hands.Drag(Place(here, random), Place(here, random), 3);
                break;
            case 7:
                here.Hands.Wheel(Place(here, random), new Vector(0, random.Next(-3, 4)));
                break;
            case 8:
                here.Hands.Press(s_keys[random.Next(s_keys.Length)]);
                break;
            default:
                if (random.Next(6) == 0) here.Hands.DropFiles(Place(here, random), [Path.Combine(here.Commands.Folder, random.Next(2) == 0 ? "gasket.dxf" : "missing.dxf")]);
                else here.Hands.MovePointer(Place(here, random));
                break;
        }
    }

    private static void Say(Operator here, string text)
    {
        here.Hands.Type(text);
        here.Hands.Press(Key.Enter);
    }

    private static Point Place(Operator here, Random random) => new(random.NextDouble() * here.Window.Bounds.Width, MenuHeight + (random.NextDouble() * (here.Window.Bounds.Height - MenuHeight)));

    /// <summary>Presses Esc until there is no prompt and no open dialog; a moving machine is stopped.</summary>
    private static void Calm(Operator here)
    {
        for (var i = 0; i < 6; i++)
        {
            here.Hands.Press(Key.Escape);
            here.Step();
        }

        if (here.Commands.Machine.Status.State is not (MachineState.Offline or MachineState.Ready)) here.Session.StopKeys.PressStop();
        here.Until(() => here.Commands.Prompt.Command is null && !here.Desk.Queue.IsBusy || Again(here));
        here.WaitUntilIdle();
    }

    private static bool Again(Operator here)
    {
        here.Hands.Press(Key.Escape);
        return false;
    }

    private static void AssertStopAnswers(Operator here)
    {
        here.Enter("CNCDISCONNECT");
        here.Open(Path.Combine(RepositoryFolder.Samples, "gasket.dxf")); // not the copy, which may have been saved in a form that cannot be cut
        here.Enter("TOOLSTART", "0,0", "CNCUNITS", "1", "CNCFEED", "60"); // from a reachable start; inches, slowly: with the current unit and feed the job may end before a busy computer presses the key
        here.Enter("CNCCONNECT", SlowSimulator.Address, "CNCARM", "Stream");
        if (here.Commands.Prompt.Command is not null) here.Enter("Yes"); // with the current settings there may be something to confirm
        var earlier = here.Commands.Machine.Runs.LastRun;
        here.Hands.Type("CNCRUN");
        here.Hands.Press(Key.Enter);
        here.Until(() => here.Commands.Machine.Status.State == MachineState.Running); // with the current rapid speed the first segment may be hours away
        here.Hands.Press(Key.Pause);
        here.WaitUntilIdle();
        var run = here.Commands.Machine.Runs.LastRun;
        if (ReferenceEquals(run, earlier)) Assert.Equal(MachineState.Ready, here.Commands.Machine.Status.State); // stopped before anything moved
        else Assert.Equal(JobOutcome.Stopped, run!.Result.Outcome);
    }

    /// <summary>Name, size and time of every file of the samples.</summary>
    private static string Prints() => string.Join('\n', new DirectoryInfo(RepositoryFolder.Samples).EnumerateFiles("*", SearchOption.AllDirectories).OrderBy(file => file.FullName, StringComparer.Ordinal).Select(file => string.Create(CultureInfo.InvariantCulture, $"{file.FullName} {file.Length} {file.LastWriteTimeUtc:O}")));
}
