using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>Concurrent commands while another one works until it is released.</summary>
public sealed class ConcurrentCommandTests : IAsyncDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-beside-");
    private readonly CancellationTokenSource _limit = new(TimeSpan.FromSeconds(60));
    private readonly List<CommandMessage> _said = [];
    private readonly WorkCommand _work = new();
    private readonly QueryCommand _look = new();
    private readonly CountCommand _count = new();
    private readonly CommandSession _session;

    public ConcurrentCommandTests()
    {
        var built = CommandCatalog.Built();
        _session = new CommandSession(new CommandEnvironment { Folder = _folder.FullName, RunJournalFolder = _folder.FullName }, new CommandCatalog([.. built.All.Select(info => built.Find(info.Name)!), _work, _look, _count]));
        _session.MessageWritten += (_, message) =>
        {
            lock (_said) _said.Add(message);
        };
        _session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 10, 0).Circle(20, 5, 3).Build() });
    }

    [Fact]
    public async Task What_only_looks_is_run_and_may_ask()
    {
        var working = EnterAsync("WORK");
        Assert.True(_session.IsBusy);
        Assert.IsType<InputResult.Done>(await EnterAsync("ZOOM E"));
        Assert.IsType<InputResult.AwaitingInput>(await EnterAsync("DIST"));
        Assert.Equal(("DIST", "WORK"), (_session.Prompt.Command, _session.RunningCommand));
        Assert.IsType<InputResult.NotAccepted>(await EnterAsync("here"));
        Assert.IsType<InputResult.AwaitingInput>(await EnterAsync("0,0"));
        Assert.IsType<InputResult.Done>(await EnterAsync("0,5"));
        Assert.Contains(_said, message => message.Text.StartsWith("Distance = 5", StringComparison.Ordinal));
        Assert.IsType<InputResult.AwaitingInput>(await EnterAsync("LIST"));
        await _session.CancelAsync();
        Assert.True(_session.IsBusy);

        _work.LetGo();
        Assert.IsType<InputResult.Done>(await working.WaitAsync(_limit.Token));
        Assert.Equal("WORK", Assert.Single(_session.Document.UndoNames.Take(1)));
    }

    [Fact]
    public async Task A_place_that_is_pointed_at_beside_the_work_is_echoed_as_lengths_are_printed()
    {
        var working = EnterAsync("WORK");
        await EnterAsync("ID");
        Assert.IsType<InputResult.Done>(await _session.PointAsync(new Point2D(1.0 / 3.0, 2.0 / 3.0), _limit.Token));
        Assert.Contains(_said, message => message.Text == "Specify point: 0.3333,0.6667");
        Assert.Equal(1.0 / 3.0, _session.LastPoint.X);
        _work.LetGo();
        await working.WaitAsync(_limit.Token);
    }

    [Theory]
    [InlineData("OSNAP")]
    [InlineData("HELP")]
    [InlineData("-OPTIONS")]
    public async Task CNCSTOP_is_a_command_whatever_is_asked_beside_the_work_and_never_an_answer(string asks)
    {
        var working = EnterAsync("WORK");
        Assert.IsType<InputResult.AwaitingInput>(await EnterAsync(asks));
        await EnterAsync("CNCSTOP");

        Assert.Null(_session.Prompt.Command);
        Assert.DoesNotContain(_said, message => message.Text.Contains("'CNCSTOP'", StringComparison.Ordinal));
        Assert.Contains(_said, message => message.Text == "No job is running.");
        _work.LetGo();
        await working.WaitAsync(_limit.Token);
    }

    [Fact]
    public async Task A_setting_of_the_drawing_is_not_changed_in_the_middle_of_a_command_that_draws()
    {
        await EnterAsync("LINE");
        await EnterAsync("0,0");
        await EnterAsync("10,0");
        await EnterAsync("'-OPTIONS");
        Assert.Contains("CNCFEED", Assert.IsType<InputResult.Failed>(await EnterAsync("CNCFEED")).Message, StringComparison.Ordinal);
        Assert.Equal("LINE", _session.Prompt.Command);
    }

    [Theory]
    [InlineData("ERASE", "ERASE can change the drawing or its job and cannot run while WORK is running. Enter it again later.")]
    [InlineData("OPEN", "OPEN can change the drawing or its job and cannot run while WORK is running. Enter it again later.")]
    [InlineData("CNCHOME", "CNCHOME acts on the machine and cannot run while WORK is running. Enter it again later. CNCSTOP, CNCHOLD and commands that only show information remain available.")]
    [InlineData("FOO", "Unknown command 'FOO'. HELP lists all commands.")]
    public async Task Everything_else_is_refused_with_the_reason(string typed, string reason)
    {
        var working = EnterAsync("WORK");
        Assert.Equal(reason, Assert.IsType<InputResult.NotAccepted>(await EnterAsync(typed)).Message);
        _work.LetGo();
        Assert.IsType<InputResult.Done>(await working.WaitAsync(_limit.Token));
    }

    [Fact]
    public async Task Every_command_of_the_catalogue_is_heard_or_refused_and_none_changes_anything()
    {
        var working = EnterAsync("WORK");
        var before = _session.Document.Current;
        foreach (var info in _session.Catalog.All.Where(info => info.Name is not ("WORK" or "LOOK" or "COUNT")))
        {
            var result = await EnterAsync(info.Name);
            Assert.True(info.CanRunConcurrently == result is not InputResult.NotAccepted, $"{info.Name}: {result}");
            await _session.Concurrent.EndAsync();
        }

        Assert.Same(before, _session.Document.Current);
        _work.LetGo();
        Assert.IsType<InputResult.Done>(await working.WaitAsync(_limit.Token));
    }

    [Theory]
    [InlineData("HISTORY", "Open")]
    [InlineData("-OPTIONS", "CNCMAXERR")]
    public async Task The_part_of_a_looking_command_that_changes_the_document_is_refused(string command, string option)
    {
        var working = EnterAsync("WORK");
        var before = _session.Document.Current;
        await EnterAsync(command);
        var result = await EnterAsync(option);
        if (result is InputResult.AwaitingInput) result = await EnterAsync("0.5");
        Assert.IsType<InputResult.Failed>(result);
        Assert.Same(before, _session.Document.Current);
        _work.LetGo();
        await working.WaitAsync(_limit.Token);
    }

    [Fact]
    public async Task Esc_while_it_works_leaves_the_document_as_it_was_however_late_it_looks()
    {
        var before = _session.Document.Current;
        var working = EnterAsync("WORK");
        await _session.CancelAsync();
        Assert.True(_session.IsEnding);
        _work.LetGo();

        Assert.IsType<InputResult.Cancelled>(await working.WaitAsync(_limit.Token));
        Assert.Same(before, _session.Document.Current);
        Assert.DoesNotContain("WORK", _session.Document.UndoNames);
    }

    /// <summary>Esc after the first answer and before the second prompt of a concurrent command (regression: the prompt remained open).</summary>
    [Fact]
    public async Task Esc_between_two_questions_of_what_is_asked_beside_the_work_ends_it()
    {
        var working = EnterAsync("WORK");
        Assert.IsType<InputResult.AwaitingInput>(await EnterAsync("LOOK"));
        var answering = EnterAsync("0,0");
        Assert.Null(_session.Prompt.Command);
        Assert.False(answering.IsCompleted);
        var ending = _session.Concurrent.EndAsync();
        _look.LetGo();

        Assert.True(await ending.WaitAsync(_limit.Token));
        Assert.IsType<InputResult.Cancelled>(await answering.WaitAsync(_limit.Token));
        Assert.Null(_session.Prompt.Command);
        Assert.False(_session.Concurrent.HasPrompt);
        Assert.True(_session.IsBusy);
        _work.LetGo();
        Assert.IsType<InputResult.Done>(await working.WaitAsync(_limit.Token));
    }

    /// <summary>Esc from another thread while a concurrent command is computing (LIST of a large drawing): it is awaited, and its token is still
    /// usable.</summary>
    [Fact]
    public async Task Esc_while_a_command_beside_the_work_computes_waits_until_it_has_ended()
    {
        var working = EnterAsync("WORK");
        var counting = Task.Run(() => EnterAsync("COUNT"));
        await _count.Begun.WaitAsync(_limit.Token);
        var ending = _session.Concurrent.EndAsync();
        Assert.False(ending.IsCompleted);
        _count.LetGo();

        Assert.False(await ending.WaitAsync(_limit.Token)); // It had not prompted.
        Assert.IsType<InputResult.Cancelled>(await counting.WaitAsync(_limit.Token));
        Assert.DoesNotContain(_said, message => message.Kind == MessageKind.Error);
        _work.LetGo();
        Assert.IsType<InputResult.Done>(await working.WaitAsync(_limit.Token));
    }

    [Fact]
    public void A_selection_made_meanwhile_is_only_of_the_drawing_that_was_seen()
    {
        var drawing = _session.Document.Current.Drawing!;
        _session.Document.SelectIn(drawing, _ => [1]);
        Assert.Equal([1], _session.Document.Current.Selection);
        _session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 1, 0).Build() });
        _session.Document.SelectIn(drawing, _ => [1]);

        Assert.Empty(_session.Document.Current.Selection);
    }

    [Fact]
    public void Suggestions_are_all_names_that_match_prefix_first_and_the_stop_before_its_neighbours()
    {
        var names = _session.Suggest("cnc").Where(found => found.Alias is null).Select(found => found.Command.Name).ToList();
        Assert.Equal("CNCSTOP", names[0]);
        Assert.Equal(_session.Catalog.All.Count(info => info.Name.Contains("CNC", StringComparison.Ordinal)), names.Count);
        Assert.Equal(["OVERKILL", "CNCOVERRIDE", "CNCRECOVER"], _session.Suggest("OVER").Where(found => found.Alias is null).Select(found => found.Text));
    }

    public async ValueTask DisposeAsync()
    {
        _work.LetGo();
        await _session.DisposeAsync();
        _limit.Dispose();
        _folder.Delete(recursive: true);
    }

    private Task<InputResult> EnterAsync(string input) => _session.EnterAsync(input, _limit.Token);

    /// <summary>Works until released, ignores cancellation, and then commits a step.</summary>
    private sealed class WorkCommand : ICommand
    {
        private readonly TaskCompletionSource _go = new(TaskCreationOptions.RunContinuationsAsynchronously);

        public CommandInfo Info { get; } = new("WORK", CommandGroup.Drawing);

        public void LetGo() => _go.TrySetResult();

        public async Task RunAsync(CommandContext context, CancellationToken cancellation)
        {
            await _go.Task;
            context.Commit(context.Document.Current with { Settings = context.Document.Current.Settings with { MaxErrorMm = 0.25 } });
        }
    }

    /// <summary>Asks for two points and ignores cancellation between them until released.</summary>
    private sealed class QueryCommand : ICommand
    {
        private readonly TaskCompletionSource _go = new(TaskCreationOptions.RunContinuationsAsynchronously);

        public CommandInfo Info { get; } = new("LOOK", CommandGroup.Drawing) { IsTransparent = true };

        public void LetGo() => _go.TrySetResult();

        public async Task RunAsync(CommandContext context, CancellationToken cancellation)
        {
            await context.AskAsync(new PointPrompt("Specify first point"));
            await _go.Task;
            await context.AskAsync(new PointPrompt("Specify second point"));
        }
    }

    /// <summary>Computes on the caller's thread until released, and then checks its token.</summary>
    private sealed class CountCommand : ICommand
    {
        private readonly TaskCompletionSource _begun = new(TaskCreationOptions.RunContinuationsAsynchronously);
        private readonly TaskCompletionSource _go = new();

        public CommandInfo Info { get; } = new("COUNT", CommandGroup.Drawing) { IsTransparent = true };

        public Task Begun => _begun.Task;

        public void LetGo() => _go.TrySetResult();

        public Task RunAsync(CommandContext context, CancellationToken cancellation)
        {
            _begun.TrySetResult();
            _go.Task.Wait(TimeSpan.FromSeconds(60), CancellationToken.None);
            cancellation.WaitHandle.WaitOne(0); // Throws if its source is disposed.
            cancellation.ThrowIfCancellationRequested();
            return Task.CompletedTask;
        }
    }
}
