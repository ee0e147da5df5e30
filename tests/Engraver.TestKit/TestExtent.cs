using System.Globalization;

namespace Engraver.TestKit;

/// <summary>The extent of a test run: the subset for each commit, or everything. <c>./test --full</c> sets ENGRAVER_FULL=1; only this class reads it.</summary>
/// <remarks>The subset uses fewer seeds, or each subject with one pair of choices instead of every combination. Only the tests with
/// <see cref="FullRunFactAttribute"/> and <see cref="FullRunTheoryAttribute"/> are omitted completely.</remarks>
public static class TestExtent
{
    /// <summary>True for the full run: every combination and the large numbers of seeds.</summary>
    public static bool IsFull { get; } = Environment.GetEnvironmentVariable("ENGRAVER_FULL") == "1";

    /// <summary>The seed of a failed property, to repeat it: <c>(state,increment)</c> for all its cases, <c>(state,increment,size)</c> for its last one.
    /// Empty if the variable is not set.</summary>
    public static string Replay { get; } = Environment.GetEnvironmentVariable("ENGRAVER_REPLAY") ?? "";

    /// <summary>The number of cases of a test.</summary>
    /// <param name="perCommit">In <c>./test</c>.</param>
    /// <param name="full">In <c>./test --full</c>.</param>
    /// <param name="variable">The environment variable that sets another number, in either run.</param>
    public static int Cases(int perCommit, int full, string variable) => Number(variable, IsFull ? full : perCommit);

    /// <summary>The number in an environment variable, or <paramref name="otherwise"/> if it is not set. Text that is not a number throws: a run of a million
    /// seeds must not shrink silently.</summary>
    public static int Number(string variable, int otherwise) => Parse(variable, Environment.GetEnvironmentVariable(variable), otherwise);

    /// <summary>The same for a text that was already read.</summary>
    public static int Parse(string variable, string? text, int otherwise)
    {
        if (string.IsNullOrEmpty(text)) return otherwise;
        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var value)) return value;
        throw new FormatException($"{variable} is '{text}', which is no whole number.");
    }

    /// <summary>Each subject with one pair of choices, so that with enough subjects every pair of choices occurs; in the full run every combination.</summary>
    public static IEnumerable<(TSubject Subject, TFirst First, TSecond Second)> InTurn<TSubject, TFirst, TSecond>(IReadOnlyList<TSubject> subjects, IReadOnlyList<TFirst> first, IReadOnlyList<TSecond> second) =>
        IsFull ? Crossed(subjects, first, second) : Rotated(subjects, first, second);

    /// <summary>The combinations of <see cref="InTurn{TSubject, TFirst, TSecond}"/> in the subset.</summary>
    public static IEnumerable<(TSubject Subject, TFirst First, TSecond Second)> Rotated<TSubject, TFirst, TSecond>(IReadOnlyList<TSubject> subjects, IReadOnlyList<TFirst> first, IReadOnlyList<TSecond> second)
    {
        for (var i = 0; i < subjects.Count; i++) yield return (subjects[i], first[i % first.Count], second[((i % first.Count) + (i / first.Count)) % second.Count]);
    }

    /// <summary>Every combination.</summary>
    public static IEnumerable<(TSubject Subject, TFirst First, TSecond Second)> Crossed<TSubject, TFirst, TSecond>(IReadOnlyList<TSubject> subjects, IReadOnlyList<TFirst> first, IReadOnlyList<TSecond> second) =>
        from subject in subjects
        from one in first
        from other in second
        select (subject, one, other);
}
