using Engraver.Core.Languages;

namespace Engraver.Tools;

/// <summary>The texts of the sources in tools. Each program that compiles them embeds their <c>Texts.resx</c>.</summary>
internal sealed class Wording : ProjectTexts<Wording>;
