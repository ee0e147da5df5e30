using Engraver.Core.Diagnostics;

namespace Engraver.Workbench.SerialTexts;

/// <summary>A plate whose numbers are spent. Disposing without a confirmation leaves it unfinished.</summary>
public sealed class SpentPlate : IDisposable
{
    private readonly CounterFile? _file;
    private readonly StartedPlate? _plate;
    private readonly IReadOnlyList<(string Counter, long Number, long Next)> _fresh;
    private readonly LivePlate? _live;

    /// <param name="fresh">Numbers that no plate had before, and the next ones after them.</param>
    internal SpentPlate(CounterFile? file, StartedPlate? plate, IReadOnlyList<(string Counter, long Number, long Next)> fresh, LivePlate? live) =>
        (_file, _plate, _fresh, _live) = (file, plate, fresh, live);

    /// <summary>A plate without counters.</summary>
    public static SpentPlate WithoutNumbers { get; } = new(null, null, [], null);

    /// <summary>The plate is finished.</summary>
    /// <returns>A warning if that could not be written: the plate then counts as unfinished.</returns>
    public Task<Diagnostic?> ConfirmAsync(CancellationToken cancellation) => ChangeAsync(document => document with { Plates = [.. document.Plates.Where(one => one.Id != _plate!.Id)] }, cancellation);

    /// <summary>Nothing was moved: numbers that no plate had before are free again, unless later ones were taken.</summary>
    /// <returns>As for <see cref="ConfirmAsync"/>.</returns>
    public Task<Diagnostic?> ReleaseAsync(CancellationToken cancellation) => ChangeAsync(
        document =>
        {
            foreach (var (counter, number, _) in _fresh.Where(one => document.NextOf(one.Counter) == one.Next)) document = document.Without(counter, number).WithNext(counter, number);
            return document;
        },
        cancellation);

    public void Dispose() => _live?.Dispose();

    private async Task<Diagnostic?> ChangeAsync(Func<CounterDocument, CounterDocument> change, CancellationToken cancellation)
    {
        if (_file is null) return null;
        try
        {
            await _file.ChangeAsync(change, cancellation).ConfigureAwait(false);
            return null;
        }
        catch (CounterException failed)
        {
            return SerialRules.NotConfirmed.At(default, _plate!.Values, failed.Finding?.Facts[^1] ?? failed.Message);
        }
    }
}
