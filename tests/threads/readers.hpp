// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <gtest/gtest.h>

#include <barrier>
#include <functional>
#include <thread>
#include <vector>

/// Several threads that read one object at the same time.
namespace limpet::threads {

/// Whatever a question was answered, as numbers.
using Answer = std::vector<double>;
using Question = std::function<Answer()>;

inline std::vector<Answer> ask(const std::vector<Question>& questions, std::size_t first = 0) {
  std::vector<Answer> answers(questions.size());
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const std::size_t k = (first + i) % questions.size();
    answers[k] = questions[k]();
  }
  return answers;
}

/// Asks all questions in several threads at once, all the same one first, then each another one, and expects
/// the answers that one thread alone gets.
inline void expect_same_answers(const std::vector<Question>& questions) {
  constexpr std::size_t kThreads = 4, kRounds = 4;
  const std::vector<Answer> alone = ask(questions);
  std::vector<std::vector<Answer>> found(kThreads * kRounds);
  std::barrier together(static_cast<std::ptrdiff_t>(kThreads));
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < kThreads; ++t)
    threads.emplace_back([&, t] {
      for (std::size_t round = 0; round < kRounds; ++round) {
        together.arrive_and_wait();
        found[t * kRounds + round] = ask(questions, t * round);
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (const auto& answers : found) EXPECT_EQ(answers, alone);
}

}  // namespace limpet::threads
