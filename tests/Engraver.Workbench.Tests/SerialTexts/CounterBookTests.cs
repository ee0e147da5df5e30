using System.Collections.Immutable;
using Engraver.TestKit;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Workbench.Tests.SerialTexts;

public sealed class CounterBookTests : IDisposable
{
    private static readonly CounterDesign[] s_serial = [new("n", 17, 5)];

    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-counters-");
    private readonly CounterBook _book;

    public CounterBookTests() => _book = NewBook();

    private string File => Path.Combine(_folder.FullName, "book", "counters.json");

    public void Dispose() => _folder.Delete(recursive: true);

    [Fact]
    public async Task A_counter_begins_at_its_start_and_continues_by_its_step()
    {
        Assert.Empty(_book.Read().Counters);
        Assert.Equal([17, 22, 27], _book.Forecast(s_serial, CounterChoice.Ask, 3).Plates.Select(plate => plate["n"]));
        Assert.False(System.IO.File.Exists(File)); // a forecast spends nothing
        await EngraveAsync(17);
        await EngraveAsync(22);
        Assert.Equal(27, Assert.Single(NewBook().Read().Counters).Next);
        Assert.Empty(_book.Read().Plates);
    }

    [Fact]
    public async Task A_number_is_on_the_disk_when_it_is_spent()
    {
        using var spent = await SpendAsync(17);
        var state = NewBook().Read();
        Assert.Equal(22, Assert.Single(state.Counters).Next);
        var plate = Assert.Single(state.Plates);
        Assert.Equal(("n=17", 17), (plate.Values, plate.Numbers["n"]));
        Assert.EndsWith("job.jsonl", plate.Journal, StringComparison.Ordinal);
    }

    [Fact]
    public async Task After_an_interruption_no_plate_starts_until_it_is_decided()
    {
        await InterruptAsync(17);
        Assert.Equal("SER0022", _book.Forecast(s_serial, CounterChoice.Ask, 1).Refusal?.Id);
        Assert.Equal("SER0022", await RefusalAsync(() => SpendAsync(22)));
        Assert.Equal([17, 22], _book.Forecast(s_serial, CounterChoice.Again, 2).Plates.Select(plate => plate["n"]));
        Assert.Equal([22, 27], _book.Forecast(s_serial, CounterChoice.Next, 2).Plates.Select(plate => plate["n"]));
    }

    [Fact]
    public async Task Again_engraves_the_number_of_the_unfinished_plate_and_then_the_next()
    {
        await InterruptAsync(17);
        await EngraveAsync(17, CounterChoice.Again);
        Assert.Empty(_book.Read().Plates);
        await EngraveAsync(22);
    }

    [Fact]
    public async Task Next_leaves_the_number_out_once()
    {
        await InterruptAsync(17);
        await EngraveAsync(22, CounterChoice.Next);
        Assert.True(Assert.Single(_book.Read().Plates).IsLeftOut);
        await EngraveAsync(27);
    }

    [Fact]
    public async Task Another_counter_is_not_concerned()
    {
        await InterruptAsync(17);
        Assert.Null(_book.Forecast([new("lot", 1, 1)], CounterChoice.Ask, 1).Refusal);
    }

    [Fact]
    public async Task Resuming_keeps_the_number_and_confirms_it()
    {
        await InterruptAsync(17);
        using (var resumed = await _book.ResumeAsync(Plate(17), CounterChoice.Ask, "plate.dxf", "second.jsonl", CancellationToken.None)) Assert.Null(await resumed.ConfirmAsync(CancellationToken.None));
        Assert.Empty(_book.Read().Plates);
        await EngraveAsync(22);
    }

    [Fact]
    public async Task A_plate_that_was_left_out_can_still_be_resumed()
    {
        await InterruptAsync(17);
        await EngraveAsync(22, CounterChoice.Next);
        using var resumed = await _book.ResumeAsync(Plate(17), CounterChoice.Ask, "plate.dxf", "second.jsonl", CancellationToken.None);
        Assert.Equal("second.jsonl", Path.GetFileName(Assert.Single(_book.Read().Plates).Journal));
    }

    [Fact]
    public async Task A_number_that_was_engraved_since_is_not_resumed_unless_it_is_requested()
    {
        await EngraveAsync(17);
        Assert.Equal("SER0024", await RefusalAsync(() => _book.ResumeAsync(Plate(17), CounterChoice.Ask, "plate.dxf", "second.jsonl", CancellationToken.None)));
        using var again = await _book.ResumeAsync(Plate(17), CounterChoice.Again, "plate.dxf", "second.jsonl", CancellationToken.None);
        Assert.Single(_book.Read().Plates);
    }

    [Fact]
    public async Task A_plate_that_did_not_move_gives_its_number_back()
    {
        using (var spent = await SpendAsync(17)) await spent.ReleaseAsync(CancellationToken.None);
        await EngraveAsync(17);
        await InterruptAsync(22);
        using (var again = await SpendAsync(22, CounterChoice.Again)) await again.ReleaseAsync(CancellationToken.None);
        Assert.Equal("SER0022", _book.Forecast(s_serial, CounterChoice.Ask, 1).Refusal?.Id);
    }

    [Fact]
    public async Task Two_programs_get_different_numbers_at_the_same_time()
    {
        using var here = await SpendAsync(17);
        var other = NewBook();
        Assert.Equal("SER0023", await RefusalAsync(() => SpendAsync(17)));
        Assert.Equal(22, other.Forecast(s_serial, CounterChoice.Ask, 1).Plates[0]["n"]);
        using var there = await SpendAsync(22);
        Assert.Null(await here.ConfirmAsync(CancellationToken.None));
        Assert.Null(await there.ConfirmAsync(CancellationToken.None));
        Assert.Empty(other.Read().Plates);
    }

    [Fact]
    public async Task Setting_a_counter_back_warns_and_leaves_unfinished_plates_out()
    {
        await EngraveAsync(17);
        await InterruptAsync(22);
        Assert.Null(await _book.SetAsync("N", 100, CancellationToken.None));
        Assert.Equal("SER0025", (await _book.SetAsync("n", 50, CancellationToken.None))?.Id);
        await EngraveAsync(50);
    }

    [Theory]
    [InlineData("")]
    [InlineData("{}")]
    [InlineData("null")]
    [InlineData("{\"version\":2}")]
    public async Task A_damaged_file_is_refused_and_kept(string content)
    {
        await EngraveAsync(17);
        System.IO.File.WriteAllText(File, content);
        Assert.Equal("SER0020", Assert.Throws<CounterException>(() => _book.Read()).Finding?.Id);
        Assert.Equal("SER0020", await RefusalAsync(() => SpendAsync(17)));
        Assert.Equal(content, System.IO.File.ReadAllText(File));
    }

    [Fact]
    public async Task A_changed_number_is_noticed()
    {
        await EngraveAsync(17);
        System.IO.File.WriteAllText(File, System.IO.File.ReadAllText(File).Replace("22", "21", StringComparison.Ordinal));
        Assert.Equal("SER0020", Assert.Throws<CounterException>(() => _book.Read()).Finding?.Id);
    }

    [Fact]
    public async Task Any_truncated_file_is_refused()
    {
        await InterruptAsync(17);
        var whole = System.IO.File.ReadAllBytes(File);
        for (var length = 0; length < whole.Length; length++)
        {
            System.IO.File.WriteAllBytes(File, whole[..length]);
            Assert.Equal("SER0020", Assert.Throws<CounterException>(() => _book.Read()).Finding?.Id);
        }
    }

    [Fact]
    public async Task A_folder_that_cannot_be_written_refuses_the_plate()
    {
        System.IO.File.WriteAllText(Path.Combine(_folder.FullName, "book"), "a file where the folder should be");
        Assert.Equal("SER0021", await RefusalAsync(() => SpendAsync(17)));
    }

    [Fact]
    public async Task The_lock_of_another_process_is_awaited()
    {
        var time = new ManualTimeProvider();
        var book = new CounterBook(File, time);
        Directory.CreateDirectory(Path.GetDirectoryName(File)!);
        Task<SpentPlate> waiting;
        using (new FileStream(File + ".lock", FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None))
        {
            waiting = book.SpendAsync(s_serial, Plate(17), CounterChoice.Ask, "plate.dxf", "job.jsonl", CancellationToken.None);
            Assert.False(waiting.IsCompleted);
        }

        time.Advance(TimeSpan.FromMilliseconds(20));
        using var spent = await waiting;
        Assert.Single(book.Read().Plates);
    }

    [Fact]
    public void A_counter_ends_at_its_limits()
    {
        Assert.Equal("SER0027", Assert.Throws<CounterException>(() => _book.Forecast([new("n", 3, -2)], CounterChoice.Ask, 3)).Finding?.Id);
        Assert.Equal("SER0027", Assert.Throws<CounterException>(() => _book.Forecast([new("n", SerialFieldReader.MaxNumber, 1)], CounterChoice.Ask, 2)).Finding?.Id);
    }

    [Fact]
    public async Task A_plate_without_counters_writes_nothing()
    {
        using var spent = await _book.SpendAsync([], new PlateValues { Copy = 1 }, CounterChoice.Ask, "plate.dxf", "job.jsonl", CancellationToken.None);
        Assert.Null(await spent.ConfirmAsync(CancellationToken.None));
        Assert.False(Directory.Exists(Path.GetDirectoryName(File)));
    }

    private CounterBook NewBook() => new(File, TimeProvider.System);

    private static PlateValues Plate(long number) => new() { Counters = ImmutableSortedDictionary<string, long>.Empty.Add("n", number) };

    private Task<SpentPlate> SpendAsync(long number, CounterChoice choice = CounterChoice.Ask) => _book.SpendAsync(s_serial, Plate(number), choice, "plate.dxf", "job.jsonl", CancellationToken.None);

    private async Task EngraveAsync(long number, CounterChoice choice = CounterChoice.Ask)
    {
        Assert.Equal(number, _book.Forecast(s_serial, choice, 1).Plates[0]["n"]);
        using var spent = await SpendAsync(number, choice);
        Assert.Null(await spent.ConfirmAsync(CancellationToken.None));
    }

    private async Task InterruptAsync(long number) => (await SpendAsync(number)).Dispose();

    private static async Task<string?> RefusalAsync(Func<Task<SpentPlate>> spend) => (await Assert.ThrowsAsync<CounterException>(spend)).Finding?.Id;
}
