using Engraver.App.Tests.Start;
using Engraver.TestKit;
using Engraver.Workbench.Settings;
using static Engraver.App.Tests.RealWindow.GivenAnswer;

namespace Engraver.App.Tests.RealWindow;

/// <summary>A new machine is commissioned (docs/operating.md) in a real window, with real keys and mouse, on a separate simulated controller behind TCP:
/// aborted once, stopped once, completed to the profile. Before each answer the window must show the question, pixel by pixel. The assertions are about
/// motors and outputs. Its pictures are stored.</summary>
[Collection(DesktopCollection.Name)]
public sealed class CommissioningWalkTests(DesktopFixture fixture)
{
    private const string Drawing = "paper-001.dxf";
    private const byte Lamp = 4;

    private static readonly IReadOnlyList<GivenAnswer> s_answers =
    [
        Click("Skip"), Click("Skip"), Click("Back"), Click("Go"), Click("Quadrature"), Click("Normal"), Click("Quadrature"), Click("Normal"),
        Click("Go"), Click("reAd"), Click("Low"), Type(""), // limit and home switches
        Click("Go"), Type("500"), Click("Yes"), Type("500"), Click("Yes"), // following error
        Click("Go"), Type("1000"), Type("6000"), new("Yes", AnswerWay.ClickedThenStopped), // A moves 6,000 counts, STOP in the middle
        Click("Back"), Click("Go"), Type("10000"), Type("5000"), Click("Yes"), Click("Left"), Click("Yes"), Type("Yes"), Click("Back"), Type("Yes"),
        Click("Go"), Type(""), Type("10000"), Click("Yes"), Type("5"), Click("Yes"), Type("10000"), Click("Yes"), Type("10"), Click("Yes"), // A has 2,000 counts/mm
        Click("Go"), Type("20000"), Click("Yes"), Click("Back"), Click("Right"), // the F has the correct orientation
        Click("Go"), Type("3"), Click("Yes"), Click("Yes"), // the lamp
        Click("Yes"), Type("new-machine.json"), Click("No"), // the profile is written, nothing burned
    ];

    [FullRunXServerFact]
    public async Task A_new_machine_from_the_first_question_to_its_profile()
    {
        using var files = new TemporaryDesktopFolder();
        await using var machine = await RealMachine.SwitchedOnAsync();
        var (drawing, profile) = (Path.Combine(RepositoryFolder.Samples, Drawing), Path.Combine(files.Path, "new-machine.json"));
        var asked = await AskedQuestions.OfAsync(fixture, drawing, files.Path, s_answers);
        File.Delete(profile); // written by the window in memory
        using var desktop = new ShownDesktop(files.Path);
        machine.StartClock();
        desktop.EnterUntil(Drawing, "OPEN", drawing);
        desktop.EnterUntil(Drawing + " - READY", "CNCCONNECT", machine.Address);
        desktop.Click(asked.Tab);

        // Aborted at the third question: nothing is kept.
        desktop.Settle();
        desktop.Click(asked.Start);
        foreach (var question in asked.All.Take(3)) Answer(desktop, question);
        desktop.Click(asked.Abort);
        desktop.Settle();
        Keep(desktop, "commission-1-broken-off");

        // From start to end.
        desktop.Click(asked.Start);
        for (var i = 0; i < asked.All.Count; i++)
        {
            var question = asked.All[i];
            if (question.Text.StartsWith("Axis A: enter the direction of motion", StringComparison.Ordinal)) KeepAt(desktop, question, "commission-3-which-way");
            if (question.Answer.Text == "new-machine.json") question = question with { Answer = Type(profile) };
            if (i > 0 && asked.All[i - 1].Answer.Way == AnswerWay.ClickedThenStopped) KeepAt(desktop, question, "commission-2-stopped");
            await AnswerAsync(desktop, machine, question);
        }

        desktop.WaitForLook(asked.EndPlace, asked.EndLook, "every step with how it ended");
        Keep(desktop, "commission-4-done");
        AssertCommissioned(machine, profile);
        Assert.Equal(0, desktop.Close());
    }

    private static async Task AnswerAsync(ShownDesktop desktop, RealMachine machine, AskedQuestion question)
    {
        if (question.Answer.Way != AnswerWay.ClickedThenStopped)
        {
            Answer(desktop, question);
            return;
        }

        desktop.WaitForLook(question.Place, question.Look, question.Text);
        desktop.Click(question.Button!.Value);
        await machine.RunUntilAsync(status => status.IsMoving && machine.Place.A > 2_000);
        desktop.Press("Pause");
        await machine.RunUntilAsync(status => status.IsIdle);
        Assert.InRange(machine.Place.A, 2_000, 5_000);
        machine.StartClock();
    }

    private static void Answer(ShownDesktop desktop, AskedQuestion question)
    {
        desktop.WaitForLook(question.Place, question.Look, question.Text);
        if (question.Button is { } button) desktop.Click(button);
        else desktop.Enter(question.Answer.Text);
    }

    private static void AssertCommissioned(RealMachine machine, string file)
    {
        var axes = MachineProfileSource.Load(file).Axes;
        Assert.Equal((('A', -2000.0), ('B', 1000.0)), ((axes.X.Letter, axes.X.CountsPerMillimetre), (axes.Y.Letter, axes.Y.CountsPerMillimetre)));
        Assert.Equal(3, MachineProfileSource.Load(file).ToolOutput);
        var rows = machine.Controller.Record.Snapshot();
        Assert.Equal(0, rows[^1].Outputs);
        var on = rows.First(row => (row.Outputs & Lamp) != 0);
        Assert.InRange(rows.First(row => row.Sample > on.Sample && (row.Outputs & Lamp) == 0).Sample - on.Sample, 500, 1_000);
        Assert.All(rows, row => Assert.Equal(0, row.Outputs & ~Lamp));
        Assert.Equal(10_000, rows.Max(row => row.B) - rows.Min(row => row.B)); // measured, and the height of the F
        Assert.Equal(machine.Place, (rows[^1].A, rows[^1].B));
    }

    private static void KeepAt(ShownDesktop desktop, AskedQuestion question, string name)
    {
        desktop.WaitForLook(question.Place, question.Look, question.Text);
        Keep(desktop, name);
    }

    private static void Keep(ShownDesktop desktop, string name)
    {
        var picture = desktop.Picture();
        Assert.InRange(picture.Length, 10_000, 200_000);
        File.WriteAllBytes(Path.Combine(ShownDesktop.Pictures, name + ".png"), picture);
    }
}
